#include "language/names/files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace language {

namespace fs = std::filesystem;

namespace {

constexpr long long kLongest = 16 << 20;     // bytes of a file on disk that is looked at: longer ones hold data
constexpr long long kMostBytes = 128 << 20;  // of files on disk that are kept
constexpr std::size_t kMostReached = 2000;   // files of a scene

}  // namespace

std::string normal_path(const std::string& path)
{
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    return (error ? fs::path(path) : absolute).lexically_normal().string();
}

void Files::open(const std::string& path, std::string text)
{
    open_[path] = std::make_unique<Open>(Open{std::move(text), nullptr});
}

void Files::close(const std::string& path) { open_.erase(path); }

std::vector<std::string> Files::open_paths() const
{
    std::vector<std::string> paths;
    for (const auto& [path, open] : open_) paths.push_back(path);
    return paths;
}

KnownPtr Files::find(const std::string& path)
{
    if (const auto open = open_.find(path); open != open_.end()) {
        if (!open->second->known) open->second->known = std::make_shared<Known>(path, open->second->text);
        return open->second->known;
    }
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return nullptr;
    const auto bytes = static_cast<long long>(fs::file_size(path, error));
    if (error || bytes > kLongest) return nullptr;
    const auto written = static_cast<long long>(fs::last_write_time(path, error).time_since_epoch().count());
    const auto kept = disk_.find(path);
    if (kept != disk_.end() && kept->second.written == written && kept->second.bytes == bytes)
        return kept->second.known;
    std::ifstream in(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!in && !in.eof()) return nullptr;
    if (disk_bytes_ + bytes > kMostBytes) disk_.clear(), disk_bytes_ = 0;
    disk_bytes_ += bytes;
    return (disk_[path] = {std::make_shared<Known>(path, std::move(text)), written, bytes}).known;
}

std::vector<std::string> Files::folders(const std::string& from, const std::string& root) const
{
    std::vector<std::string> all{""};
    const auto add = [&](const std::string& folder) {
        if (std::find(all.begin(), all.end(), folder) == all.end()) all.push_back(folder);
    };
    for (const std::string& folder : library_path_) add(folder);
    add(fs::path(root).parent_path().string());
    add(fs::path(from).parent_path().string());
    return all;
}

std::string Files::included(const std::string& name, const std::string& from, const std::string& root) const
{
    if (name.empty() || name.find('\0') != std::string::npos) return {};
    std::vector<std::string> names{name + ".inc", name + ".INC", name};
    if (name.ends_with(".inc") || name.ends_with(".INC")) names.insert(names.begin(), name);
    for (const std::string& candidate : names)
        for (const fs::path folder : folders(from, root)) {
            const std::string path = normal_path((folder / candidate).string());  // an absolute one replaces the folder
            std::error_code error;
            if (open_.contains(path) || fs::is_regular_file(path, error)) return path;
        }
    return {};
}

std::vector<std::string> Files::reached(const std::string& root)
{
    std::vector<std::string> all{root};
    std::set<std::string> seen{root};
    for (std::size_t at = 0; at < all.size() && all.size() < kMostReached; ++at) {
        const KnownPtr known = find(all[at]);
        if (!known) continue;
        for (const std::size_t name : known->outline.includes) {
            std::string path = included(std::string(known->document.string(name)), all[at], root);
            if (!path.empty() && seen.insert(path).second) all.push_back(std::move(path));
        }
    }
    return all;
}

std::vector<std::string> Files::related(const std::string& path)
{
    std::vector<std::string> all = reached(path);
    for (const auto& [root, open] : open_) {
        const std::vector<std::string> others = reached(root);
        if (std::find(others.begin(), others.end(), path) == others.end()) continue;
        for (const std::string& other : others)
            if (std::find(all.begin(), all.end(), other) == all.end()) all.push_back(other);
    }
    return all;
}

}  // namespace language
