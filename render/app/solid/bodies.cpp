#include "render/app/solid/bodies.h"

#include "csg/base/cancel.h"
#include "function/field/field.h"
#include "render/app/run/run.h"
#include "render/app/frames/frames.h"
#include "render/app/run/scene_file.h"
#include "render/app/run/scene_reading.h"
#include "render/app/run/stage_options.h"
#include "render/layers/object_names.h"
#include "render/kernel/kernel.h"
#include "render/picture/kernel_module.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace app {
namespace {

void put_message(void*, const parser::Message& message)
{
    if (message.severity == parser::Severity::Error) return;  // thrown
    fmt::print(stderr, "{}\n", message_text(message));
}

/// The line that includes the scene stands before its #version, which is no mistake of the scene.
void put_message_of_include(void* context, const parser::Message& message)
{
    if (!message.text.starts_with("the first #version")) put_message(context, message);
}

bool is_name(const std::string& word)
{
    return !word.empty() && std::isdigit(static_cast<unsigned char>(word[0])) == 0 &&
           std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

/// The scene with the named object behind all others.
parser::Result parse_with_name(const std::string& file, const std::string& name, parser::Options& options)
{
    if (!is_name(name)) throw OptionError(fmt::format("--object wants a declared name, found '{}'", name));
    const std::string path = std::filesystem::absolute(file).string();
    options.library_path.insert(options.library_path.begin(), std::filesystem::path(path).parent_path().string());
    std::string quoted;
    for (const char c : path) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return parser::parse_text(fmt::format("#include \"{}\"\nobject {{ {} }}\n", quoted, name), "--object", options,
                              put_message_of_include);
}

}  // namespace

bool take_value(const std::vector<std::string>& arguments, std::size_t& i, const std::vector<std::string>& names,
                std::string& value)
{
    const std::string& word = arguments[i];
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    if (std::find(names.begin(), names.end(), name) == names.end()) return false;
    if (equals != std::string::npos) {
        value = word.substr(equals + 1);
    } else {
        if (i + 1 == arguments.size()) throw OptionError(name + " wants a value");
        value = arguments[++i];
    }
    if (value.empty()) throw OptionError(name + " wants a value");
    return true;
}

BodyScene read_bodies(const BodyRequest& request, Cancellation& cancel)
{
    const Settings& settings = request.settings;
    if (settings.input_file.empty()) throw OptionError("no scene given");
    function::use(trace::load_kernel(isa_of(settings)).evaluators);
    const std::string file = find_scene(settings);
    SceneReading reading(settings, cancel.requested);
    parser::Options& options = reading.options;
    BodyScene out;
    if (request.object.empty()) {
        out.description = parser::parse_file(file, options, put_message).scene;
    } else {
        out.description = parse_with_name(file, request.object, options).scene;
    }
    const scene::Description& description = out.description;
    for (const scene::Unsupported& what : description.unsupported)
        fmt::print(stderr, "note: {} is not available yet\n", what.what);
    const bool one = !request.object.empty();  // the last
    const std::vector<std::string> names = one ? std::vector<std::string>(description.objects.size(), request.object)
                                               : layers::object_names(description, [](const std::string& path) {
                                                     return text_on_disk(path).value_or("");
                                                 });
    for (std::size_t i = one ? description.objects.size() - 1 : 0; i < description.objects.size(); ++i)
        if (!scene::is_light(description.objects[i])) out.objects.push_back({names[i], &description.objects[i]});
    return out;
}

int tell_thrown()
{
    try {
        throw;
    } catch (const parser::Cancelled&) {
        fmt::print(stderr, "cancelled\n");
        return kCancelled;
    } catch (const csg::Cancelled&) {
        fmt::print(stderr, "cancelled\n");
        return kCancelled;
    } catch (const OptionError&) {
        throw;  // told as of every run
    } catch (const scene::Error& error) {
        for (const scene::Message& message : error.messages()) fmt::print(stderr, "{}\n", message_text(message));
    } catch (const std::exception& error) {
        fmt::print(stderr, "whittle: error: {}\n", error.what());
    }
    return kError;
}

}  // namespace app
