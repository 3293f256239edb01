#include "render/app/options/nearest.h"
#include "render/app/run/scene_file.h"
#include "render/app/views/view_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

// Cameras as JSON: {"views": [{"name": "left", "location": [0, 1, -5], "look_at": [0, 0, 0], "angle": 40}, ...]}
namespace app {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestFile = 16 << 20, kMostCameras = 10'000;
constexpr int kMostSide = 1000;  ///< views along a side of a sheet

constexpr std::array<const char*, 9> kKinds = {"perspective",      "orthographic", "fisheye",
                                               "ultra_wide_angle", "omnimax",      "panoramic",
                                               "spherical",        "cylinder 1",   "cylinder 3"};

/// What a view may say beside its name, its type and its matrix: words of a camera statement, in the order in which
/// they are written, and how many numbers each wants.
struct Item {
    const char* name;
    int numbers;
};
constexpr std::array<Item, 12> kItems = {{{"location", 3},
                                          {"sky", 3},
                                          {"direction", 3},
                                          {"right", 3},
                                          {"up", 3},
                                          {"angle", 1},
                                          {"look_at", 3},
                                          {"aperture", 1},
                                          {"focal_point", 3},
                                          {"blur_samples", 1},
                                          {"confidence", 1},
                                          {"variance", 1}}};

/// One view, with what a mistake in it is called.
class ViewReader {
public:
    ViewReader(const std::string& path, std::size_t number, const json& view, const Settings& settings)
        : path_(path), number_(number), view_(view), aspect_(static_cast<double>(settings.width) / settings.height)
    {
        if (!view.is_object()) fail("it has to be an object");
    }

    std::string name(std::size_t digits)
    {
        const auto given = view_.find("name");
        if (given == view_.end()) return fmt::format("{:0{}}", number_, digits);
        if (!given->is_string()) fail("'name' has to be a text");
        const auto name = given->get<std::string>();
        const bool plain = !name.empty() && name.size() <= 64 && name[0] != '.' &&
                           std::all_of(name.begin(), name.end(), [](unsigned char c) {
                               return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c >= 0x80;
                           });
        if (!plain) fail("'name' becomes a part of a file's name: letters, digits, '_', '-' and '.', 64 at most");
        return name;
    }

    std::string text()
    {
        check_keys();
        std::string text = fmt::format("camera {{\n  {}", kind());
        const bool placed = view_.contains("matrix");
        if (placed) text += matrix();
        for (const Item& item : kItems) {
            const auto given = view_.find(item.name);
            if (given == view_.end()) {
                // A picture's pixels are squares.
                if (!placed && std::string_view(item.name) == "right")
                    text += fmt::format("\n  right <{}, 0, 0>", aspect_);
                continue;
            }
            text += fmt::format("\n  {} {}", item.name, value(item, *given));
        }
        return text + "\n}\n";
    }

    [[noreturn]] void fail(const std::string& why) const
    {
        throw scene::Error({path_, {}}, fmt::format("view {}: {}", number_, why));
    }

private:
    void check_keys() const
    {
        std::vector<std::string> known{"name", "type", "matrix"};
        for (const Item& item : kItems) known.emplace_back(item.name);
        for (const auto& [key, value] : view_.items())
            if (std::find(known.begin(), known.end(), key) == known.end())
                fail(fmt::format("it has a '{}', which no camera has{}", key, did_you_mean(key, known)));
        if (!view_.contains("matrix")) return;
        for (const char* other : {"location", "direction", "right", "up", "sky", "look_at"})
            if (view_.contains(other)) fail(fmt::format("'matrix' says what '{}' says", other));
    }

    std::string kind() const
    {
        const auto given = view_.find("type");
        if (given == view_.end()) return "perspective";
        for (const char* known : kKinds)
            if (given->is_string() && given->get_ref<const std::string&>() == known) return known;
        fail(fmt::format("'type' has to be one of {}", fmt::join(kKinds, ", ")));
    }

    double number(const json& from, const char* name) const
    {
        if (!from.is_number() || !std::isfinite(from.get<double>())) fail(fmt::format("'{}' has to be numbers", name));
        return from.get<double>();
    }

    std::string value(const Item& item, const json& given) const
    {
        if (item.numbers == 1) return fmt::format("{}", number(given, item.name));
        if (!given.is_array() || given.size() != 3)
            fail(fmt::format("'{}' has to be three numbers, as in [0, 1, 0]", item.name));
        return vector_in_text({number(given[0], item.name), number(given[1], item.name), number(given[2], item.name)});
    }

    /// From the camera to the scene, which it looks at along its -z with y up, as in glTF and in files of photographs:
    /// four rows, or 16 numbers column by column.
    std::string matrix() const
    {
        const json& given = view_.at("matrix");
        std::array<std::array<double, 4>, 4> m{};
        const bool rows = given.is_array() && given.size() == 4;
        if (!rows && !(given.is_array() && given.size() == 16))
            fail("'matrix' has to be 4 rows of 4 numbers, or 16 numbers");
        for (std::size_t row = 0; row < 4; ++row) {
            if (rows && !(given[row].is_array() && given[row].size() == 4))
                fail("a row of 'matrix' has to be 4 numbers");
            for (std::size_t column = 0; column < 4; ++column)
                m[row][column] = number(rows ? given[row][column] : given[4 * column + row], "matrix");
        }
        if (m[3][0] != 0.0 || m[3][1] != 0.0 || m[3][2] != 0.0 || m[3][3] != 1.0)
            fail("the last row of 'matrix' has to be 0, 0, 0, 1");
        const auto column = [&](std::size_t i, double factor) {
            return vector_in_text({factor * m[0][i], factor * m[1][i], factor * m[2][i]});
        };
        return fmt::format("\n  location {}\n  direction {}\n  right {}\n  up {}", column(3, 1.0), column(2, -1.0),
                           column(0, aspect_), column(1, 1.0));
    }

    const std::string& path_;
    std::size_t number_;  ///< from 1
    const json& view_;
    double aspect_;
};

json read_json(const std::string& path)
{
    const auto text = text_on_disk(path);
    if (!text) throw scene::Error({path, {}}, "cannot read this file of cameras");
    if (text->size() > kLongestFile) throw scene::Error({path, {}}, "this file of cameras is too long");
    constexpr int kDeepest = 8;
    bool too_deep = false;
    const json::parser_callback_t guard = [&](int depth, json::parse_event_t, json&) {
        too_deep = too_deep || depth > kDeepest;
        return !too_deep;
    };
    try {
        json out = json::parse(*text, guard);
        if (too_deep) throw scene::Error({path, {}}, "this file of cameras is nested too deeply");
        return out;
    } catch (const json::parse_error& error) {
        const std::size_t at = std::min<std::size_t>(error.byte > 0 ? error.byte - 1 : 0, text->size());
        const auto line = 1 + std::count(text->begin(), text->begin() + static_cast<std::ptrdiff_t>(at), '\n');
        const std::size_t begin = at == 0 ? 0 : text->rfind('\n', at - 1) + 1;
        throw scene::Error({path, {static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(at - begin + 1)}},
                           "this is no JSON");
    }
}

}  // namespace

SceneViews views_in_file(const std::string& path, const Settings& settings)
{
    const json file = read_json(path);
    const auto fail = [&](const std::string& why) { throw scene::Error({path, {}}, why); };
    if (!file.is_array() && !file.is_object()) fail("a list of views is wanted, or an object with \"views\"");
    if (file.is_object())
        for (const auto& [key, value] : file.items())
            if (key != "views" && key != "sheet")
                fail(fmt::format("'{}' is not known here{}", key, did_you_mean(key, {"views", "sheet"})));
    const json none;
    const json& list = file.is_array() ? file : file.contains("views") ? file.at("views") : none;
    if (!list.is_array() || list.empty() || list.size() > kMostCameras)
        fail(fmt::format("\"views\" has to be a list of 1 to {} cameras", kMostCameras));
    SceneViews out;
    std::set<std::string> names;
    const std::size_t digits = std::max<std::size_t>(2, std::to_string(list.size()).size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        ViewReader reader(path, i + 1, list[i], settings);
        out.views.push_back({reader.name(digits), reader.text()});
        if (!names.insert(out.views.back().name).second) reader.fail("another view has its name");
    }
    if (!file.is_object() || !file.contains("sheet")) return out;
    const json& sheet = file.at("sheet");
    const auto side = [&](std::size_t i) {
        const bool whole = sheet.is_array() && sheet.size() == 2 && sheet[i].is_number_integer() &&
                           sheet[i].get<double>() >= 1 && sheet[i].get<double>() <= kMostSide;
        if (!whole) fail("\"sheet\" has to be its columns and its rows, as in [4, 2]");
        return sheet[i].get<int>();
    };
    out.sheet = SheetForm{side(0), side(1), false, {}};
    if (static_cast<std::size_t>(out.sheet->columns) * static_cast<std::size_t>(out.sheet->rows) < list.size())
        fail("\"sheet\" has fewer places than there are views");
    return out;
}

}  // namespace app
