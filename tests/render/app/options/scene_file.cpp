#include "render/app/run/scene_file.h"

#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

using namespace app;

namespace {

std::string found(const std::string& name, const std::vector<std::string>& library_path = {})
{
    Settings settings;
    settings.input_file = name;
    settings.library_path = library_path;
    return find_scene(settings);
}

}  // namespace

// Each case was watched in POV-Ray 3.7.0.10.
TEST_CASE("the file that an input name means", "[app]")
{
    const support::TemporaryFolder folder, other;
    for (const char* name : {"a.pov", "b.POV", "c", "c.pov"}) std::ofstream(folder / name) << "\n";
    for (const char* name : {"a.pov", "d.pov"}) std::ofstream(other / name) << "\n";

    CHECK(found(folder / "a.pov") == folder / "a.pov");
    CHECK(found(folder / "a") == folder / "a.pov");
    CHECK(found(folder / "b") == folder / "b.POV");
    CHECK(found(folder / "c") == folder / "c.pov");  // the extension first
    CHECK(found("d.pov", {folder.path(), other.path()}) == other / "d.pov");
    CHECK(found("d", {folder.path(), other.path()}) == other / "d.pov");
    CHECK(found("a", {other.path(), folder.path()}) == other / "a.pov");
    CHECK(found("none.pov", {other.path()}) == "none.pov");
}
