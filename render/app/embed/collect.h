#pragma once

#include "parser/parse.h"
#include "render/app/run/run.h"

#include <memory>
#include <string>

namespace app {

/// A file of a run under the name that it gets in a picture.
struct NamedFile {
    std::string path, name;
};

/// Names for the files of a run, such that a run in their folder finds each where this one did, in the same order:
/// what lies below the current folder keeps its name, what a folder of the library path holds lies in library/N, what
/// is above is reached by as many folders more. Paths of this machine do not go along.
class FileNames {
public:
    /// \param library  folders as they are searched
    FileNames(const std::string& scene, const std::vector<std::string>& library, const std::vector<std::string>& files);
    const std::vector<NamedFile>& files() const { return files_; }  ///< each once, the scene first
    const std::string& start() const { return start_; }             ///< the current folder of the run; empty: the top
    /// In the order of a search, those alone that hold a file.
    const std::vector<std::string>& folders() const { return folders_; }
    std::string name_of(const std::string& path) const;                     ///< empty: it is none of them
    const std::vector<std::string>& absolute() const { return absolute_; }  ///< that no folder leads to

private:
    std::vector<NamedFile> files_;
    std::string start_;
    std::vector<std::string> folders_, absolute_;
};

/// What a picture is to carry of this run, packed; null unless --embed asks for it. Throws scene::Error where files are
/// too long.
std::shared_ptr<const std::string> carried_of(Run& run, const Frame& frame, const parser::Options& reading,
                                              const parser::Result& parsed);

}  // namespace app
