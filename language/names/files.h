#pragma once

#include "language/names/outline.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace language {

/// A text and what it declares.
struct Known {
    Known(const std::string& path, std::string text) : document(path, std::move(text)), outline(outline_of(document)) {}
    Document document;
    Outline outline;
};
using KnownPtr = std::shared_ptr<const Known>;

/// Texts by absolute path without "." and "..". A text that an editor has open hides the file on disk; files on disk
/// are kept in memory until they change or there are too many.
class Files {
public:
    /// Where include files are searched after the current folder and before that of the scene, in order.
    explicit Files(std::vector<std::string> library_path) : library_path_(std::move(library_path)) {}

    void open(const std::string& path, std::string text);
    void close(const std::string& path);
    bool is_open(const std::string& path) const { return open_.contains(path); }
    std::vector<std::string> open_paths() const;
    const std::string& text(const std::string& path) const { return open_.at(path)->text; }

    /// Null: there is no such file, or one that is too long to be looked at.
    KnownPtr find(const std::string& path);

    /// The file that `#include "name"` means in a text that the scene `root` reads; empty: there is none.
    std::string included(const std::string& name, const std::string& from, const std::string& root) const;
    /// The folders in which it is searched, in order.
    std::vector<std::string> folders(const std::string& from, const std::string& root) const;

    /// The paths of a text and all that it includes: itself first, the others in the order of reading.
    std::vector<std::string> reached(const std::string& root);
    /// The paths of texts that may share names with one: all that it reaches, and all that open texts reach which reach
    /// it.
    std::vector<std::string> related(const std::string& path);

private:
    struct Open {
        std::string text;
        KnownPtr known;  ///< made when it is asked for
    };
    struct OnDisk {
        KnownPtr known;
        long long written = 0, bytes = 0;  ///< the file's time and length when it was read
    };
    std::vector<std::string> library_path_;
    std::map<std::string, std::unique_ptr<Open>> open_;
    std::map<std::string, OnDisk> disk_;
    long long disk_bytes_ = 0;
};

/// Absolute, without "." and "..".
std::string normal_path(const std::string& path);

}  // namespace language
