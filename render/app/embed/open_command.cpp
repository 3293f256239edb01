#include "render/app/embed/open_command.h"

#include "render/app/embed/carried_options.h"
#include "render/app/embed/unpack.h"
#include "render/app/options/settings.h"
#include "render/app/run/run.h"
#include "render/image/carried_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace app {
namespace {

constexpr const char* kOpenUsage = R"(usage: whittle open PICTURE [-o FOLDER] [--list] [--replace]

Takes out what a picture carries that was rendered with --embed: the scene, the files that it read, and its options as an INI file.
What is printed makes the same picture again. Files that are there are not overwritten.

  -o FOLDER   where to; usual: the picture's name without its ending, here
  --list      print what it carries, and write nothing
  --replace   files that are there with other contents are overwritten

Exit status: 0 done, 1 the picture carries nothing, is damaged, or a file is in the way.
)";

struct OpenRequest {
    std::string picture, folder;
    bool list = false, replace = false;
};

OpenRequest open_request(const std::vector<std::string>& arguments)
{
    OpenRequest request;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& word = arguments[i];
        if (word == "--list") request.list = true;
        else if (word == "--replace") request.replace = true;
        else if (word == "-o" || word == "--out") {
            if (i + 1 == arguments.size()) throw OptionError(word + " wants a folder");
            request.folder = arguments[++i];
        } else if (word.starts_with("--out=")) request.folder = word.substr(6);
        else if (word.starts_with('-') && word.size() > 1) throw OptionError("unknown option '" + word + "'");
        else if (!request.picture.empty()) throw OptionError("open takes one picture");
        else request.picture = word;
    }
    if (request.picture.empty()) throw OptionError("no picture given: whittle open x.png -o folder");
    const std::filesystem::path stem = std::filesystem::path(request.picture).stem();
    if (request.folder.empty()) request.folder = stem.string();
    return request;
}

/// A name for the options, where the scene's names start.
std::string ini_name(const OpenRequest& request, const Carried& carried)
{
    std::string stem = std::filesystem::path(request.picture).stem().string();
    const std::string before = carried.folder.empty() ? "" : carried.folder + "/";
    while (std::any_of(carried.files.begin(), carried.files.end(),
                       [&](const Carried::File& f) { return f.name == before + stem + ".ini"; }))
        stem += "_picture";
    return before + stem + ".ini";
}

int open_picture(const OpenRequest& request)
{
    const auto bytes = image::carried_in(request.picture);
    if (!bytes) throw std::runtime_error("it carries no scene: it was not rendered with --embed");
    Carried carried = unpacked(*bytes);
    for (const std::string& line : carried.options)
        if (!may_bring(line, carried.folder))
            throw std::runtime_error(fmt::format("its options have a line that no picture may bring: '{}'", line));
    std::string ini = fmt::format("; of {}\n", std::filesystem::path(request.picture).filename().string());
    for (const std::string& line : carried.options) ini += line + "\n";
    const std::string name = ini_name(request, carried);
    const std::size_t count = carried.files.size();
    carried.files.push_back({name, std::move(ini)});
    if (!is_inner_name(name)) throw std::runtime_error("its name is none that its options can have");
    if (request.list) {
        for (const Carried::File& file : carried.files) fmt::print("{:>10}  {}\n", file.bytes.size(), file.name);
        return kSuccess;
    }
    put_files(carried.files, request.folder, request.replace);
    const std::filesystem::path at(request.folder), ini_path(name);
    fmt::print("{}  {} file{}; cd {} && whittle {}\n", request.folder, count, count == 1 ? "" : "s",
               (at / ini_path.parent_path()).lexically_normal().string(), ini_path.filename().string());
    return kSuccess;
}

}  // namespace

std::string open_help() { return kOpenUsage; }

int open_command(const std::vector<std::string>& arguments)
{
    const OpenRequest request = open_request(arguments);
    try {
        return open_picture(request);
    } catch (const std::exception& error) {
        fmt::print(stderr, "whittle: error: {}: {}\n", request.picture, error.what());
        return kError;
    }
}

}  // namespace app
