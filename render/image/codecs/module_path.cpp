#include "render/image/codecs/module_path.h"

#include "render/image/pixels/picture.h"

#include <dlfcn.h>
#include <sys/auxv.h>

#include <cstdlib>
#include <utility>

namespace image {
namespace {

using Folders = std::vector<std::filesystem::path>;

Folders of_library;  // that is not the program

/// What the system was told to start: without /proc (a bare chroot) from the start's own notes.
std::filesystem::path started_file()
{
    std::error_code failed;
    std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
    if (!failed) return program;
    const auto* started = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
    program = started != nullptr ? std::filesystem::canonical(started, failed) : std::filesystem::path();
    return failed ? std::filesystem::path(started) : program;
}

Folders module_folders()
{
    if (!of_library.empty()) return of_library;
    const std::filesystem::path program = program_file().parent_path();
    return {program, (program / WHITTLE_MODULES_FROM_PROGRAM).lexically_normal()};
}

std::string named(const Folders& folders)
{
    std::string text;
    for (std::size_t i = 0; i < folders.size(); ++i)
        text += (i == 0 ? "'" : i + 1 == folders.size() ? "' nor in '" : "', '") + folders[i].string();
    return text + "'";
}

}  // namespace

std::filesystem::path program_file()
{
    std::filesystem::path started = started_file();
    const char* const launcher = std::getenv("WHITTLE_LAUNCHER");
    // Programs that a launched one starts inherit the variable: it speaks of those alone that a loader runs.
    const bool by_loader = launcher != nullptr && started.filename().string().starts_with("ld-");
    return by_loader ? std::filesystem::path(launcher) : started;
}

void look_for_modules_in(std::vector<std::filesystem::path> folders) { of_library = std::move(folders); }

std::optional<std::filesystem::path> find_module(const std::string& name)
{
    std::error_code ignored;
    for (const std::filesystem::path& folder : module_folders())
        if (std::filesystem::is_regular_file(folder / name, ignored)) return folder / name;
    return std::nullopt;
}

std::string missing_module(const std::string& name)
{
    return "the program is not complete: '" + name + "' is neither in " + named(module_folders()) +
           "; a program that is copied needs the modules beside it, cmake --install puts all in place";
}

void* module_entry(const std::string& name, const char* entry)
{
    const std::optional<std::filesystem::path> module = find_module(name);
    if (!module) throw FileError(missing_module(name));
    void* const handle = dlopen(module->c_str(), RTLD_LAZY | RTLD_LOCAL);  // lazy: OpenImageIO in 0.20 s, not 0.215
    if (handle == nullptr) throw FileError("cannot load '" + name + "': " + dlerror());
    void* const found = dlsym(handle, entry);
    if (found == nullptr) throw FileError("'" + module->string() + "' is not ours");
    return found;
}

}  // namespace image
