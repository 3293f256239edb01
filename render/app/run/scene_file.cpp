#include "render/app/run/scene_file.h"

#include "render/files/whole_file.h"

#include <filesystem>

namespace app {

namespace fs = std::filesystem;

std::string find_scene(const Settings& settings)
{
    const std::string& name = settings.input_file;
    std::vector<std::string> candidates{name + ".pov", name + ".POV"};
    const bool extended = name.ends_with(".pov") || name.ends_with(".POV");
    candidates.insert(extended ? candidates.begin() : candidates.end(), name);

    std::vector<fs::path> folders{fs::path()};
    folders.insert(folders.end(), settings.library_path.begin(), settings.library_path.end());
    std::error_code ignored;
    for (const std::string& candidate : candidates)
        for (const fs::path& folder : folders)  // an absolute candidate replaces the folder
            if (fs::is_regular_file(folder / candidate, ignored)) return (folder / candidate).string();
    return name;
}

std::optional<std::string> text_on_disk(const std::string& path) { return files::whole_file_if(path); }

}  // namespace app
