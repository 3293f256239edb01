#include "render/app/embed/collect.h"

#include "render/app/embed/carried.h"
#include "render/app/embed/carried_options.h"
#include "render/app/run/scene_file.h"
#include "render/app/views/views.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr int kMostUp = 8;  ///< folders above one that names may lead to

fs::path whole(const fs::path& path) { return fs::absolute(path).lexically_normal(); }

/// How many folders up a relative path begins with.
int ups(const fs::path& relative)
{
    int count = 0;
    for (const fs::path& part : relative) {
        if (part != "..") break;
        ++count;
    }
    return count;
}

bool lies_in(const fs::path& path, const fs::path& folder)
{
    const fs::path relative = path.lexically_relative(folder);
    return !relative.empty() && *relative.begin() != "..";
}

/// How many steps up a path has anywhere.
int steps_up(const fs::path& path) { return static_cast<int>(std::count(path.begin(), path.end(), "..")); }

/// A folder from which names in the scene start.
struct Root {
    std::string given;   ///< as paths found in it begin
    fs::path folder;     ///< absolute
    std::string stored;  ///< its name in the picture, for what is not above it; empty: the top
    int up = 0;          ///< folders above it that files lie in
    bool used = false;
    bool whole_paths = false;  ///< of the current folder: such a path means a file in it too
    bool current = false;      ///< another beginning of paths in the current folder

    bool begins(const std::string& path) const
    {
        if (given.empty()) return !fs::path(path).is_absolute() || (whole_paths && lies_in(whole(path), folder));
        return path.size() > given.size() + 1 && path.starts_with(given) &&
               (path[given.size()] == '/' || given.back() == '/');
    }
    fs::path relative(const std::string& path) const { return whole(path).lexically_relative(folder); }
    fs::path top() const
    {
        fs::path out = folder;
        for (int i = 0; i < up; ++i) out = out.parent_path();
        return out;
    }
    std::string name_of(const std::string& path) const
    {
        return (fs::path(stored) / whole(path).lexically_relative(top())).lexically_normal().string();
    }
    /// Where names that start from it are looked up.
    std::string place() const
    {
        const std::string name = (fs::path(stored) / folder.lexically_relative(top())).lexically_normal().string();
        return name.ends_with('/') ? name.substr(0, name.size() - 1) : name;
    }
};

/// Without a slash at its end, which "folder/name" has but once.
fs::path folder_path(const std::string& text)
{
    const fs::path path = whole(text.empty() ? "." : text);
    return path.has_filename() ? path : path.parent_path();
}

}  // namespace

FileNames::FileNames(const std::string& scene, const std::vector<std::string>& library,
                     const std::vector<std::string>& files)
{
    std::vector<std::string> paths{scene};
    for (const std::string& file : files)
        if (std::find(paths.begin(), paths.end(), file) == paths.end()) paths.push_back(file);

    std::vector<Root> roots{{"", folder_path("."), "", 0, true, fs::path(scene).is_absolute()}};
    std::vector<std::pair<std::size_t, fs::path>>
        searched;  // by root: a folder of the library path below the current one
    const auto taken = [&](const std::string& name) {
        return std::any_of(paths.begin(), paths.end(), [&](const std::string& p) { return p.starts_with(name + "/"); });
    };
    for (const std::string& folder : library) {
        const fs::path path = folder_path(folder);
        if (lies_in(path, roots[0].folder)) {
            searched.emplace_back(0, path);
            if (fs::path(folder).is_absolute()) roots.push_back({folder, path, "", 0, false, false, true});
            continue;
        }
        searched.emplace_back(roots.size(), path);
        roots.push_back({folder, path, "library"});  // and a number, if it is of use
    }
    const fs::path beside = folder_path(fs::path(scene).parent_path().string());
    if (!lies_in(beside, roots[0].folder))
        roots.push_back({fs::path(scene).parent_path().string(), beside, taken("scene") ? "scene_files" : "scene"});

    // Of roots that a path begins with, the longest is meant. A name that steps up may be found by another folder than
    // the current one; where it is taken out it must not be found above that.
    std::vector<Root*> of(paths.size());
    for (std::size_t i = 0; i < paths.size(); ++i) {
        Root* root = nullptr;
        for (Root& one : roots)
            if (one.begins(paths[i]) && (!root || one.given.size() > root->given.size())) root = &one;
        const int steps = root ? steps_up(paths[i].substr(root->given.size())) : 0;
        if (root && root->current) root = &roots[0];
        if (!root || steps > kMostUp) {
            absolute_.push_back(paths[i]);
            continue;
        }
        of[i] = root;
        root->up = std::max(root->up, ups(root->relative(paths[i])));
        roots[0].up = std::max(roots[0].up, steps);
        root->used = true;
    }
    int number = 0;
    for (const auto& [root, path] : searched)
        if (root != 0 && roots[root].used) {
            do roots[root].stored = fmt::format("library/{}", ++number);
            while (taken(roots[root].stored));
        }
    std::set<std::string> names;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        std::string name = of[i] ? of[i]->name_of(paths[i]) : "absolute/" + whole(paths[i]).relative_path().string();
        if (names.insert(name).second) files_.push_back({paths[i], std::move(name)});
    }
    if (roots[0].up > 0) start_ = roots[0].place();
    for (const auto& [root, path] : searched) {
        if (root != 0 && roots[root].used) folders_.push_back(roots[root].place());
        if (root != 0) continue;
        const std::string name = path.lexically_relative(roots[0].top()).string();
        const bool holds = std::any_of(files_.begin(), files_.end(),
                                       [&](const NamedFile& f) { return f.name.starts_with(name + "/"); });
        if (holds) folders_.push_back(name);
    }
}

std::string FileNames::name_of(const std::string& path) const
{
    for (const NamedFile& file : files_)
        if (file.path == path) return file.name;
    return {};
}

std::shared_ptr<const std::string> carried_of(Run& run, const Frame& frame, const parser::Options& reading,
                                              const parser::Result& parsed)
{
    const Settings& settings = run.settings;
    if (!settings.embed) return nullptr;
    const std::string scene = run.input ? "stdin.pov" : find_scene(settings);
    std::vector<std::string> paths;
    for (const std::vector<std::string>* some : {&parsed.scene.files, &parsed.data_files})
        for (const std::string& path : *some)
            if (!run.input || path != "stdin") paths.push_back(path);
    if (settings.radiosity_from_file) paths.push_back(settings.radiosity_file);
    const FileNames names(scene, reading.library_path, paths);

    Carried carried;
    std::size_t all = 0;
    const NamedFile* longest = nullptr;
    std::size_t length = 0;
    for (const NamedFile& file : names.files()) {
        const bool typed = run.input && &file == &names.files().front();
        auto bytes = typed ? run.input : text_on_disk(file.path);
        if (!bytes)
            throw scene::Error({file.path, {}}, "cannot read this file again, to put it into the picture (--embed)");
        all += bytes->size();
        if (bytes->size() >= length) {
            length = bytes->size();
            longest = &file;
        }
        if (all > kMostCarriedBytes || carried.files.size() >= kMostCarriedFiles)
            throw scene::Error({longest->path, {}},
                               fmt::format("--embed takes {} MB and {} files at most, and this scene reads more; this "
                                           "one alone has {:.1f} MB",
                                           kMostCarriedBytes >> 20, kMostCarriedFiles,
                                           static_cast<double>(length) / (1 << 20)));
        if (!is_inner_name(file.name)) throw scene::Error({file.path, {}}, "--embed cannot keep a file of this name");
        carried.files.push_back({file.name, std::move(*bytes)});
    }
    for (const std::string& path : names.absolute())
        run.reporter.note(fmt::format("{} is named by its whole path: the picture carries it, but its scene, taken out "
                                      "elsewhere, looks for it there",
                                      path));
    carried.folder = names.start();
    const auto name_option = [&](const char* keyword, const std::string& name) {
        carried.options.push_back(file_option(keyword, name, carried.folder));
    };
    name_option("Input_File_Name", names.files().front().name);
    for (const std::string& folder : names.folders()) name_option("Library_Path", folder);
    if (!settings.include_header.empty() && parsed.scene.files.size() > 1)  // the first that is included
        name_option("Include_Header", names.name_of(parsed.scene.files[1]));
    if (settings.radiosity_from_file) name_option("Radiosity_File_Name", names.name_of(settings.radiosity_file));
    if (!settings.views.empty() && !is_view_words(settings.views)) {
        auto cameras = text_on_disk(settings.views);
        if (!cameras) throw scene::Error({settings.views, {}}, "cannot read this file of cameras");
        const std::string before = carried.folder.empty() ? "" : carried.folder + "/";
        std::string name = "views.json";
        while (std::any_of(carried.files.begin(), carried.files.end(),
                           [&](const auto& f) { return f.name == before + name; }))
            name = "views_" + name;
        carried.files.push_back({before + name, std::move(*cameras)});
        carried.options.push_back("--views=" + name);
    }
    const std::vector<std::string> others = picture_options(settings, run.list.animation ? &frame.number : nullptr);
    carried.options.insert(carried.options.end(), others.begin(), others.end());
    return std::make_shared<const std::string>(packed(carried));
}

}  // namespace app
