#include "parser/stream/files/file_policy.h"

#include <algorithm>
#include <filesystem>

namespace parser {

namespace fs = std::filesystem;

bool lies_below(const std::string& file, const std::string& folder)
{
    std::error_code error;
    const fs::path inner = fs::weakly_canonical(fs::absolute(file), error),
                   outer = fs::weakly_canonical(fs::absolute(folder), error);
    const fs::path way = inner.lexically_relative(outer);
    return !error && !way.empty() && *way.begin() != "..";
}

bool may_write(const Options& options, const std::string& file)
{
    const auto below = [&](const std::string& folder) { return lies_below(file, folder); };
    return below(".") || std::any_of(options.write_folders.begin(), options.write_folders.end(), below);
}

bool may_read(const Options& options, const std::string& scene_folder, const std::string& file)
{
    if (!options.restrict_read || may_write(options, file) ||
        lies_below(file, scene_folder.empty() ? "." : scene_folder))
        return true;
    return std::any_of(options.library_path.begin(), options.library_path.end(),
                       [&](const std::string& folder) { return lies_below(file, folder); });
}

}  // namespace parser
