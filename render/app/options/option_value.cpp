#include "render/app/options/ini_file.h"
#include "render/app/options/nearest.h"
#include "render/app/options/option_table.h"
#include "render/app/base/text.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace app {

namespace {

std::optional<image::TransferCurve> curve_called(std::string_view name)
{
    if (same_text(name, "srgb")) return image::TransferCurve::srgb();
    if (same_text(name, "bt709")) return image::TransferCurve::bt709();
    if (same_text(name, "bt2020")) return image::TransferCurve::bt2020();
    return std::nullopt;
}

/// Agrees with one of the words up to the end of the shorter one.
bool begins_as(std::string_view text, std::initializer_list<std::string_view> words)
{
    return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
        const std::size_t length = std::min(word.size(), text.size());
        return same_text(word.substr(0, length), text.substr(0, length));
    });
}

/// What POV-Ray takes for false is anything but a truth; only what says so is taken here.
bool untruth(std::string_view text) { return begins_as(text, {"off", "false", "no", "0"}); }

/// Numbers are read as far as they go: 9x is 9.
Value value_of(const Option& option, const std::string& text)
{
    Value value{text, truth_of(text), 0, 0.0, {}};
    const std::string keyword(option.keyword);
    char* end = nullptr;
    switch (option.kind) {
    case ValueKind::Flag:
        if (!value.flag && !untruth(text)) throw OptionError(keyword + " wants on or off, found '" + text + "'");
        return value;
    case ValueKind::Text: return value;
    case ValueKind::Integer: value.integer = static_cast<int>(std::strtol(text.c_str(), &end, 10)); break;
    case ValueKind::Gamma:
        if (const auto curve = curve_called(text)) return value.curve = *curve, value;
        [[fallthrough]];
    case ValueKind::Number: value.number = std::strtod(text.c_str(), &end); break;
    }
    if (end == text.c_str()) throw OptionError(keyword + " wants a number, found '" + text + "'");
    if (option.kind != ValueKind::Gamma) return value;
    if (!(value.number > 0.0))
        throw OptionError(keyword + " wants a number above 0 or sRGB, BT709 or BT2020, found '" + text + "'");
    value.curve = image::TransferCurve::power(static_cast<float>(value.number));
    return value;
}

/// Keeps what was given, for Create_Ini and --json.
void record(Settings& settings, std::string_view keyword, const std::string& text)
{
    if (keyword == "Bits_Per_Colour") keyword = "Bits_Per_Color";
    if (keyword == "Greyscale_Output") keyword = "Grayscale_Output";
    std::vector<std::string>& values = settings.given[std::string(keyword)];
    if (keyword != "Library_Path" && keyword != "Declare") values.clear();
    values.push_back(text);
}

}  // namespace

image::FileType file_type_of(char letter)
{
    constexpr std::string_view kLetters = "NPTCJBEH";
    const char upper = upper_case(letter);
    if (kLetters.find(upper) == std::string_view::npos)
        throw OptionError(std::string("unknown output file type '") + letter + "'");
    return static_cast<image::FileType>(upper);
}

void set_option(Settings& settings, std::string_view keyword, const std::string& text)
{
    const Option* option = find_option(keyword);
    if (!option) throw OptionError("unknown option '" + std::string(keyword) + "'" + nearest_keyword(keyword));
    const Value value = value_of(*option, text);
    if (option->state != State::Obsolete) record(settings, option->keyword, text);
    if (option->state == State::Acts) return option->apply(settings, value);
    if (option->state == State::Obsolete) throw OptionError(std::string(option->keyword) + " is obsolete");
    // Asking for what happens anyway needs no remark: -TH, Radiosity_To_File=off.
    if (option->state != State::NotYet || (option->kind == ValueKind::Flag && !value.flag)) return;
    const std::string name(option->keyword);
    auto& noted = settings.not_acted_on;
    if (std::find(noted.begin(), noted.end(), name) == noted.end()) noted.push_back(name);
}

bool truth_of(std::string_view text) { return begins_as(text, {"on", "true", "yes", "1"}); }

void set_file_type_switch(Settings& settings, const std::string& text)
{
    settings.file_type = file_type_of(text[0]);
    record(settings, "Output_File_Type", text.substr(0, 1));
    std::string_view rest = std::string_view(text).substr(1);
    if (!rest.empty() && same_text(rest.substr(0, 1), "g")) {
        settings.greyscale = true;
        record(settings, "Grayscale_Output", "on");
        rest.remove_prefix(1);
    }
    if (rest.empty()) return;
    int bits = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), bits);
    if (error != std::errc() || end != rest.data() + rest.size())
        throw OptionError("unknown output file type '" + text + "'");
    settings.bits_per_color = bits;
    record(settings, "Bits_Per_Color", std::to_string(bits));
}

}  // namespace app
