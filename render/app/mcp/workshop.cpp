#include "render/app/mcp/tools.h"

#include "parser/stream/files/file_policy.h"
#include "render/app/output/whole_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace app::mcp {
namespace {

namespace fs = std::filesystem;

constexpr int kPicturesKept = 16;
constexpr std::size_t kLongestScene = std::size_t{16} << 20;  // bytes

bool is_declared_name(const std::string& name)
{
    return !name.empty() && name.size() <= 40 && std::isdigit(static_cast<unsigned char>(name[0])) == 0 &&
           std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

/// A line of an INI file for each of `declare`.
std::string declarations(const json& arguments)
{
    const auto given = arguments.find("declare");
    if (given == arguments.end()) return {};
    if (!given->is_object())
        throw Refusal(ErrorCode::InvalidParams, "'declare' has to be an object of names and values");
    std::string ini;
    for (const auto& [name, value] : given->items()) {
        if (!is_declared_name(name))
            throw Refusal(ErrorCode::InvalidParams,
                          fmt::format("'declare' wants names of the language, found '{}'", name));
        if (value.is_number()) {
            ini += fmt::format("Declare={}={}\n", name, value.get<double>());
            continue;
        }
        const std::string text = value.is_string() ? value.get<std::string>() : std::string("\n");
        if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == '"' || c == '\''; }))
            throw Refusal(ErrorCode::InvalidParams,
                          fmt::format("'{}' of 'declare' has to be a number, or a text without quotes", name));
        ini += fmt::format("Declare={}=\"{}\"\n", name, text);
    }
    return ini;
}

}  // namespace

double number_in(const json& arguments, const char* name, double least, double most, double usual)
{
    const auto given = arguments.find(name);
    if (given == arguments.end()) return usual;
    const double value = given->is_number() ? given->get<double>() : std::nan("");
    if (!(value >= least && value <= most))
        throw Refusal(ErrorCode::InvalidParams,
                      fmt::format("'{}' has to be a number from {:g} to {:g}", name, least, most));
    return value;
}

json text_content(const std::string& text) { return {{"type", "text"}, {"text", text}}; }

json text_result(const std::string& text, bool failed)
{
    return {{"content", json::array({text_content(text)})}, {"isError", failed}};
}

ChildResult Workshop::run(const json& arguments, const std::function<int()>& work)
{
    ChildLimits limits = walls_.limits;
    limits.seconds = number_in(arguments, "seconds", 0.1, limits.seconds, limits.seconds);
    ChildResult result = run_child(limits, work, listen_, wanted_);
    result.out = cleaned(std::move(result.out));
    result.err = cleaned(std::move(result.err));
    if (result.cancelled) throw ToolFailure("cancelled");
    if (result.too_large)
        throw ToolFailure(
            fmt::format("stopped: it took more than the {} MB of memory that it may", limits.memory >> 20));
    if (result.signal != 0) throw ToolFailure(fmt::format("it was ended by signal {}\n{}", result.signal, result.err));
    return result;
}

std::string Workshop::inner_file(const std::string& name) const
{
    if (name.find('\0') != std::string::npos || name.empty())
        throw Refusal(ErrorCode::InvalidParams, "a file's name is wrong");
    const std::string path = (fs::path(walls_.folder) / name).lexically_normal().string();
    std::error_code error;
    if (!parser::lies_below(path, walls_.folder))
        throw Refusal(ErrorCode::InvalidParams, fmt::format("'{}' does not lie below the server's folder", name));
    if (!fs::is_regular_file(path, error)) throw ToolFailure(fmt::format("there is no file '{}' in the folder", name));
    return path;
}

std::string Workshop::scene_file(const json& arguments)
{
    const auto text = arguments.find("scene"), file = arguments.find("file");
    if ((text == arguments.end()) == (file == arguments.end()))
        throw Refusal(ErrorCode::InvalidParams,
                      "either 'scene' (its text) or 'file' (a .pov below the folder) is wanted");
    if (file != arguments.end()) {
        if (!file->is_string()) throw Refusal(ErrorCode::InvalidParams, "'file' has to be a text");
        std::string path = inner_file(file->get<std::string>());
        if (!path.ends_with(".pov")) throw Refusal(ErrorCode::InvalidParams, "'file' has to be a scene, *.pov");
        return path;
    }
    if (!text->is_string()) throw Refusal(ErrorCode::InvalidParams, "'scene' has to be a text");
    const auto& scene = text->get_ref<const std::string&>();
    if (scene.size() > kLongestScene) throw Refusal(ErrorCode::InvalidParams, "'scene' has more than 16 MB");
    std::string path = scratch_ / "scene.pov";
    put_bytes(path, scene);
    return path;
}

std::string Workshop::options_file(const json& arguments)
{
    const double width = std::floor(number_in(arguments, "width", 1, 1e5, 320)),
                 height = std::floor(number_in(arguments, "height", 1, 1e5, 240));
    if (width * height > walls_.pixels)
        throw Refusal(ErrorCode::InvalidParams, fmt::format("a picture may have {:.0f} pixels here, not {:.0f}x{:.0f}",
                                                            walls_.pixels, width, height));
    std::string ini = fmt::format("Width={:.0f}\nHeight={:.0f}\n", width, height);
    if (arguments.contains("clock")) ini += fmt::format("Clock={}\n", number_in(arguments, "clock", -1e9, 1e9, 0));
    if (const auto smooth = arguments.find("antialias"); smooth != arguments.end()) {
        if (!smooth->is_boolean()) throw Refusal(ErrorCode::InvalidParams, "'antialias' has to be true or false");
        ini += fmt::format("Antialias={}\n", smooth->get<bool>() ? "On" : "Off");
    }
    ini += declarations(arguments);
    std::string path = scratch_ / "options.ini";
    put_bytes(path, ini);
    return path;
}

std::string Workshop::picture_file(const json& arguments, const char* name)
{
    const std::string& given = rpc::string_member(arguments, name);
    std::error_code error;
    const bool own = given.starts_with("render-") && given.find('/') == std::string::npos;
    if (own && fs::is_regular_file(scratch_ / given, error)) return scratch_ / given;
    return inner_file(given);
}

std::string Workshop::cleaned(std::string text) const
{
    const std::string scratch = scratch_ / "", folder = walls_.folder + "/";
    for (const std::string& path : {scratch, folder})
        for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path, at))
            text.erase(at, path.size());
    return text;
}

std::string Workshop::next_picture()
{
    ++pictures_;
    std::error_code ignored;
    if (pictures_ > kPicturesKept)
        fs::remove(scratch_ / fmt::format("render-{}.png", pictures_ - kPicturesKept), ignored);
    return fmt::format("render-{}.png", pictures_);
}

}  // namespace app::mcp
