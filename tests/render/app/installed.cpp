#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>

// The program in other places than the folder of the build.

namespace {

namespace fs = std::filesystem;

constexpr const char* kAnyScene =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0, 0, -4> look_at 0 }\n"
    "sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 } }\n";

void require_works(const support::TemporaryFolder& folder, const std::string& program)
{
    for (const char* type : {"+FN", "+FE"}) {  // with and without the module for picture files
        const support::Ended ended = support::run_program(folder.path(), program, {"scene.pov", "+W8", "+H6", type});
        INFO(program << " " << type << "\n" << ended.err);
        REQUIRE(ended.status == 0);
    }
}

}  // namespace

TEST_CASE("what cmake --install puts in place works there, moved and through links", "[program][install]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "scene.pov", kAnyScene);
    const support::Ended installed =
        support::run_program(folder.path(), WHITTLE_CMAKE, {"--install", WHITTLE_BUILD, "--prefix", folder / "first"});
    INFO(installed.out << installed.err);
    REQUIRE(installed.status == 0);
    for (const char* file :
         {"bin/whittle", "bin/povray-whittle", "share/man/man1/whittle.1", "share/bash-completion/completions/whittle",
          "share/zsh/vendor-completions/_whittle", "share/applications/whittle.desktop"})
        CHECK(fs::exists(folder / (std::string("first/") + file)));
    require_works(folder, folder / "first/bin/whittle");
    fs::rename(folder / "first", folder / "moved");
    require_works(folder, folder / "moved/bin/whittle");
    fs::create_directories(folder / "elsewhere");
    fs::create_symlink(folder / "moved/bin/whittle", folder / "elsewhere/render");
    fs::create_symlink("elsewhere/render", folder / "link");
    require_works(folder, folder / "link");
}

TEST_CASE("a copy of the program says what it lacks before it renders", "[program][install]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "scene.pov", kAnyScene);
    fs::create_directories(folder / "bin");
    fs::copy_file(WHITTLE_PROGRAM, folder / "bin/whittle");
    const auto told = [&](const char* type) {
        const support::Ended ended =
            support::run_program(folder.path(), folder / "bin/whittle", {"scene.pov", "+W8", "+H6", type});
        CHECK(ended.status == 1);
        CHECK_FALSE(fs::exists(folder / "scene.png"));
        return ended.err;
    };
    const std::string where =
        " is neither in '" + (folder / "bin") + "' nor in '" + (folder / "lib/whittle") +
        "'; a program that is copied needs the modules beside it, cmake --install puts all in place\n";
    CHECK_THAT(told("+FN"), Catch::StartsWith("whittle: error: the program is not complete: 'libwhittle_kernel_v") &&
                                Catch::EndsWith(".so'" + where));
    // Kernels alone will do for PNG.
    for (const auto& entry : fs::directory_iterator(fs::path(WHITTLE_PROGRAM).parent_path()))
        if (entry.path().filename().string().starts_with("libwhittle_kernel_"))
            fs::copy_file(entry.path(), folder / "bin/" + entry.path().filename().string());
    CHECK(told("+FE") == "whittle: error: the program is not complete: 'libwhittle_image_io.so'" + where);
    CHECK(told("+FJ") == "whittle: error: the program is not complete: 'libwhittle_pictures.so'" + where);
    CHECK(support::run_program(folder.path(), folder / "bin/whittle", {"scene.pov", "+W8", "+H6"}).status == 0);
}
