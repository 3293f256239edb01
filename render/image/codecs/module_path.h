#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace image {

/// The program's own file, links followed. Where a portable archive's launcher has its own C library's loader run the
/// program
/// (`packaging/launcher.sh`), the launcher: that is what can be started again, and what the modules stand beside.
std::filesystem::path program_file();

/// Modules that the program opens at run time stand beside the program's own file, whatever link it was called by (so a
/// build leaves them), or in the folder where `cmake --install` puts them, `lib/whittle` beside `bin`.
std::optional<std::filesystem::path> find_module(const std::string& name);

/// Folders to look into in place of those of the program, for a library that runs in another program, as Python's does.
/// Call it before the first module is asked for.
void look_for_modules_in(std::vector<std::filesystem::path> folders);

/// What to tell where there is none: its name, the folders that were looked into, and what to do.
std::string missing_module(const std::string& name);

/// A function of a module, by the name that it leaves it under. The module stays loaded. Throws FileError.
void* module_entry(const std::string& name, const char* entry);

}  // namespace image
