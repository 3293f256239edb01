#include "render/app/mcp/tools.h"

#include "render/app/compare_command.h"
#include "render/app/lsp/reading.h"
#include "render/app/options/command_line.h"
#include "render/app/pixel/pixel_command.h"
#include "render/app/program.h"
#include "render/app/run/scene_file.h"
#include "render/app/solid/info_command.h"
#include "render/app/solid/mesh_command.h"
#include "render/image/base64.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <unistd.h>

namespace app::mcp {
namespace {

constexpr std::size_t kLongestBlob = std::size_t{8} << 20;  // bytes that a result carries
constexpr std::size_t kLongestText = 200'000;               // bytes that a model reads

/// A word of the command line that is not split at blanks.
std::string whole_word(const std::string& text)
{
    return text.find(' ') == std::string::npos ? text : "\"" + text + "\"";
}

/// The words that each command gets: the scene, its options, and the walls.
Words words_for(Workshop& shop, const json& arguments)
{
    Words words{whole_word(shop.options_file(arguments)), "--restrict-read"};
    for (const std::string& folder : shop.walls().library) words.push_back(whole_word("+L" + folder));
    words.push_back(whole_word(shop.scene_file(arguments)));
    return words;
}

std::string shortened(std::string text)
{
    if (text.size() <= kLongestText) return text;
    text.resize(kLongestText);
    return text + "\n... (more was left out)\n";
}

std::string told(const ChildResult& result, const Workshop& shop)
{
    std::string text = result.err.empty()   ? result.out
                       : result.out.empty() ? result.err
                                            : result.out + "\n" + result.err;
    if (result.late)
        text += fmt::format(
            "\nstopped: it took longer than it may ({:g} s at most); a smaller picture or a coarser tolerance "
            "takes less\n",
            shop.walls().limits.seconds);
    return shortened(std::move(text));
}

json resource(const std::string& uri, const char* type, const std::string& path, bool text)
{
    const auto bytes = text_on_disk(path);
    if (!bytes) throw ToolFailure("what was made cannot be read");
    if (bytes->size() > kLongestBlob)
        throw ToolFailure(
            fmt::format("it has {} bytes, more than the {} that a result carries: a larger tolerance makes it "
                        "smaller",
                        bytes->size(), kLongestBlob));
    json inner = {{"uri", uri}, {"mimeType", type}};
    if (text) inner["text"] = *bytes;
    else inner["blob"] = image::base64(*bytes);
    return {{"type", "resource"}, {"resource", std::move(inner)}};
}

void add_value(Words& words, const json& arguments, const char* name, const char* option, double least, double most)
{
    if (arguments.contains(name))
        words.push_back(fmt::format("{}={}", option, number_in(arguments, name, least, most, 0)));
}

void add_object(Words& words, const json& arguments)
{
    const auto given = arguments.find("object");
    if (given == arguments.end()) return;
    const std::string& name = rpc::string_member(arguments, "object");
    if (name.empty() || name.size() > 100 ||
        !std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; }))
        throw Refusal(ErrorCode::InvalidParams, "'object' has to be a declared name");
    words.push_back("--object=" + name);
}

/// "; did you mean 'sphere'?" at the end of a message: what to write instead.
std::string suggestion_in(const std::string& text)
{
    constexpr std::string_view kBefore = "did you mean '";
    const std::size_t at = text.find(kBefore);
    if (at == std::string::npos) return {};
    const std::size_t begin = at + kBefore.size(), end = text.find('\'', begin);
    return end == std::string::npos ? std::string() : text.substr(begin, end - begin);
}

json message_json(const lsp::Told& told)
{
    const scene::Message& message = told.message;
    json out = {{"severity", scene::name_of(message.severity)}, {"text", message.text}};
    const auto place = [](json& to, const scene::Place& at) {
        if (at.path.empty()) return;
        to["file"] = at.path;
        if (at.at.line == 0) return;
        to["line"] = at.at.line;
        to["column"] = at.at.column;
    };
    place(out, message.place);
    if (!told.check.empty()) out["check"] = told.check;
    if (message.quote) out["source"] = message.quote->text;
    if (const std::string instead = suggestion_in(message.text); !instead.empty()) out["suggestion"] = instead;
    json because = json::array();
    for (const scene::RelatedPlace& one : message.related) {
        json place_of{{"text", one.text}};
        place(place_of, one.place);
        because.push_back(std::move(place_of));
    }
    if (message.opened) {
        json place_of{{"text", "opened here"}};
        place(place_of, *message.opened);
        because.push_back(std::move(place_of));
    }
    if (!because.empty()) out["because"] = std::move(because);
    return out;
}

/// Reads the scene as the language server does, and prints what it has to tell.
int check_scene(const Words& words, const ChildLimits& limits)
{
    Settings settings;
    apply_command_line(settings, words);
    lsp::Limits reading;
    reading.seconds = 0.8 * limits.seconds;  // the loop that takes so long is named
    reading.memory = limits.memory / 2;
    std::promise<lsp::Reading> promised;
    lsp::Reader reader(settings, reading, [&](lsp::Reading&& made) { promised.set_value(std::move(made)); });
    reader.ask(settings.input_file, std::make_shared<lsp::Reader::Texts>());
    const lsp::Reading made = promised.get_future().get();
    json messages = json::array();
    constexpr std::size_t kMost = 100;
    for (const lsp::Told& told : made.told)
        if (told.message.severity != scene::Severity::Debug && messages.size() < kMost)
            messages.push_back(message_json(told));
    json out{{"readable", made.whole}, {"messages", std::move(messages)}};
    fmt::print("{}", rpc::text_of(out));
    std::fflush(stdout);
    _exit(kSuccess);  // its threads have nothing more to do
}

/// Becomes the renderer, which stands in a program of its own.
int become_renderer(const Words& words, const std::string& folder)
{
    const char* const program = std::getenv("WHITTLE_PROGRAM");
    if (program == nullptr || chdir(folder.c_str()) != 0) throw std::runtime_error("the renderer cannot be found");
    Words copy = words;
    copy.insert(copy.begin(), "whittle");
    std::vector<char*> pointers;
    for (std::string& word : copy) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    execv(program, pointers.data());
    throw std::runtime_error("the renderer cannot be started");
}

}  // namespace

json check_tool(Workshop& shop, const json& arguments)
{
    const Words words = words_for(shop, arguments);
    ChildLimits limits = shop.walls().limits;
    limits.seconds = number_in(arguments, "seconds", 0.1, limits.seconds, limits.seconds);
    const ChildResult result = shop.run(arguments, [&] { return check_scene(words, limits); });
    const json found = json::parse(result.out, nullptr, false);
    if (!found.is_object()) throw ToolFailure("the scene could not be read\n" + told(result, shop));
    std::string text;
    for (const json& one : found["messages"]) {
        if (one.contains("line"))
            text += fmt::format("{}:{}:{}: ", one.value("file", ""), one.value("line", 0), one.value("column", 0));
        text += fmt::format("{}: {}\n", one.value("severity", ""), one.value("text", ""));
        if (one.contains("source")) text += fmt::format("    {}\n", one.value("source", ""));
        if (one.contains("because"))
            for (const json& why : one["because"])
                text +=
                    fmt::format("  {} ({}:{})\n", why.value("text", ""), why.value("file", ""), why.value("line", 0));
    }
    if (text.empty()) text = "no messages: the scene can be read\n";
    json out = text_result(shortened(std::move(text)));
    out["structuredContent"] = found;
    return out;
}

json render_tool(Workshop& shop, const json& arguments)
{
    const std::string name = shop.next_picture(), folder = shop.scratch() / "";
    Words words = words_for(shop, arguments);
    const Words more{whole_word("+L" + shop.walls().folder), "+O" + name, "+FN8", "--state-after=1000000", "-D"};
    words.insert(words.end(), more.begin(), more.end());
    const ChildResult result = shop.run(arguments, [&] { return become_renderer(words, folder); });
    std::string picture = folder + name;
    std::error_code error;
    if (!std::filesystem::exists(picture, error)) {
        std::filesystem::path part(picture);
        part.replace_extension(".partial.png");
        if (!result.late || !std::filesystem::exists(part, error)) return text_result(told(result, shop), true);
        std::filesystem::rename(part, picture, error);
    }
    const auto bytes = text_on_disk(picture);
    if (!bytes || bytes->size() > kLongestBlob) throw ToolFailure("the picture is too large for a result");
    json image{{"type", "image"}, {"data", image::base64(*bytes)}, {"mimeType", "image/png"}};
    std::string text = told(result, shop);
    if (result.late) text = "What was done in time, the rest black.\n" + text;
    return {{"content", json::array({std::move(image), text_content(fmt::format("{}\n{}", name, text))})},
            {"isError", false}};
}

json pixel_tool(Workshop& shop, const json& arguments)
{
    Words words = words_for(shop, arguments);
    words.push_back(
        fmt::format("{:.0f},{:.0f}", number_in(arguments, "x", 0, 1e5, 0), number_in(arguments, "y", 0, 1e5, 0)));
    const ChildResult result = shop.run(arguments, [&] { return cancellable<pixel_command>(words); });
    return text_result(told(result, shop), result.status != 0);
}

json info_tool(Workshop& shop, const json& arguments)
{
    Words words = words_for(shop, arguments);
    add_object(words, arguments);
    add_value(words, arguments, "precision", "--precision", 1e-6, 1);
    words.push_back("--json");
    const ChildResult result = shop.run(arguments, [&] { return cancellable<info_command>(words); });
    return text_result(told(result, shop), result.status != 0 && result.out.empty());
}

json section_tool(Workshop& shop, const json& arguments)
{
    const std::string& axis = rpc::string_member(arguments, "axis");
    if (axis != "x" && axis != "y" && axis != "z")
        throw Refusal(ErrorCode::InvalidParams, "'axis' has to be x, y or z");
    Words words = words_for(shop, arguments);
    add_object(words, arguments);
    add_value(words, arguments, "tolerance", "--tolerance", 1e-6, 1e6);
    const std::string out = shop.scratch() / "section.svg";
    std::error_code ignored;
    std::filesystem::remove(out, ignored);
    words.push_back(fmt::format("--section={},{}", axis, number_in(arguments, "value", -1e9, 1e9, 0)));
    words.insert(words.end(), {"-o", out, "--json", fmt::format("--seconds={}", 0.7 * shop.walls().limits.seconds)});
    const ChildResult result = shop.run(arguments, [&] { return cancellable<info_command>(words); });
    json made = text_result(told(result, shop), result.status != 0);
    if (std::filesystem::exists(out, ignored))
        made["content"].push_back(resource("whittle://section.svg", "image/svg+xml", out, true));
    return made;
}

json mesh_tool(Workshop& shop, const json& arguments)
{
    const std::string format = arguments.contains("format") ? rpc::string_member(arguments, "format") : "stl";
    struct Form {
        const char *name, *type;
    };
    constexpr Form kForms[] = {{"stl", "model/stl"},
                               {"obj", "model/obj"},
                               {"ply", "application/octet-stream"},
                               {"3mf", "model/3mf"},
                               {"glb", "model/gltf-binary"}};
    const auto* const form =
        std::find_if(std::begin(kForms), std::end(kForms), [&](const Form& f) { return f.name == format; });
    if (form == std::end(kForms))
        throw Refusal(ErrorCode::InvalidParams, "'format' has to be stl, obj, ply, 3mf or glb");
    Words words = words_for(shop, arguments);
    add_object(words, arguments);
    add_value(words, arguments, "tolerance", "--tolerance", 1e-6, 1e6);
    const std::string name = "part." + format, out = shop.scratch() / name;
    std::error_code ignored;
    std::filesystem::remove(out, ignored);
    words.insert(words.end(), {"-o", out, fmt::format("--seconds={}", 0.5 * shop.walls().limits.seconds)});
    const ChildResult result = shop.run(arguments, [&] { return cancellable<mesh_command>(words); });
    json made = text_result(told(result, shop), result.status != 0);
    if (std::filesystem::exists(out, ignored))
        made["content"].push_back(resource("whittle://" + name, form->type, out, false));
    return made;
}

json compare_tool(Workshop& shop, const json& arguments)
{
    const Words words{shop.picture_file(arguments, "a"), shop.picture_file(arguments, "b"), "--flip",
                      fmt::format("--tolerance={}", number_in(arguments, "tolerance", 0, 255, 3))};
    const ChildResult result = shop.run(arguments, [&] { return compare_command(words); });
    return text_result(told(result, shop), result.status > 1);
}

}  // namespace app::mcp
