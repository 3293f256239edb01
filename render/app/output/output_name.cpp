#include "render/app/output/output_name.h"

namespace app {

namespace {

/// Folder (with its slash) and name without its last extension.
struct Name {
    std::string folder, base;
};

Name split(const std::string& path)
{
    const std::size_t slash = path.rfind('/');
    const std::size_t start = slash == std::string::npos ? 0 : slash + 1;
    return {path.substr(0, start), path.substr(start)};
}

std::string without_extension(const std::string& base)
{
    const std::size_t dot = base.rfind('.');
    return dot == std::string::npos ? base : base.substr(0, dot);
}

std::string with_zeros(int number, std::size_t digits)
{
    std::string text = std::to_string(number);
    if (text.size() < digits) text.insert(0, digits - text.size(), '0');
    return text;
}

/// Parts stand in their order where names are sorted.
std::string part_ending(int part, int parts)
{
    const std::string all = std::to_string(parts);
    return "." + with_zeros(part, all.size()) + "-of-" + all + ".whittle-part";
}

Name output_name(const Settings& settings, const std::string& extension)
{
    const Name scene = split(settings.input_file == "-" ? "stdin" : settings.input_file);
    if (settings.output_file.empty()) return {scene.folder, without_extension(scene.base)};
    Name given = split(settings.output_file);
    if (given.base.empty() || given.base == extension) return {given.folder, without_extension(scene.base)};
    if (given.base.ends_with('.')) given.base.pop_back();
    else if (given.base.ends_with(extension)) given.base.resize(given.base.size() - extension.size());
    return given;
}

}  // namespace

std::string prepared_path(const Settings& settings, const std::string& path)
{
    const std::string ending = settings.shards > 0 ? part_ending(settings.shard, settings.shards)
                                                   : image::extension(settings.file_type);
    return path.substr(0, path.size() - ending.size()) + ".whittle-prepared";
}

bool to_standard_output(const Settings& settings)
{
    return settings.output_file == "-" || settings.output_file == "stdout";
}

bool to_standard_error(const Settings& settings) { return settings.output_file == "stderr"; }

std::string output_path(const Settings& settings, const FrameList& list, const Frame& frame)
{
    if (to_standard_output(settings) || to_standard_error(settings)) return {};
    const std::string extension = image::extension(settings.file_type);
    const Name name = output_name(settings, extension);
    std::string number;
    if (list.animation) number = with_zeros(frame.number, static_cast<std::size_t>(list.digits));
    const std::string base = name.folder + name.base + number;
    return settings.shards > 0 ? base + part_ending(settings.shard, settings.shards) : base + extension;
}

}  // namespace app
