// What callers of `povray` rely on when something goes wrong, or when they treat the program badly.
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <filesystem>
#include <regex>

namespace {

using support::Ended;
using support::RunningProgram;
using support::run_program;
using support::write_text;

constexpr const char* kEmptyScene = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -z }\n";

/// Minutes, if nobody ends it.
constexpr const char* kEndless =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0, 0, -4> look_at 0 }\n"
    "light_source { <-5, 5, -5>, 1 area_light x*3, y*3, 17, 17 }\nplane { y, -1 pigment { granite } finish { "
    "reflection 0.3 } }\n"
    "sphere { 0, 1 pigment { rgb 1 } finish { reflection 0.5 } }\n";

}  // namespace

TEST_CASE("an error in a scene is one line with file and line number, then lines that begin with a blank", "[callers]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "x.pov", std::string(kEmptyScene) + "shpere { 0, 1 }\n");
    const Ended ended = run_program(folder.path(), WHITTLE_AS_POVRAY, {"x.pov", "-D", "Width=1024", "Height=768"});
    CHECK(ended.status == 1);
    // The problem matcher of vscode-povray; Emacs looks for "Error:", VMD's and LeoCAD's callers for the lines at the
    // end.
    CHECK(std::regex_search(ended.err, std::regex("\nFile 'x\\.pov' line 4: Parse Error: [^\n]+\n [^\n]+\n")));
    CHECK_THAT(ended.err, Catch::Contains("\nFatal error in parser: Cannot parse input.\nRender failed\n"));
    CHECK_THAT(ended.err, !Catch::Contains("POV-Ray finished"));
    CHECK_FALSE(std::filesystem::exists(folder / "x.png"));
}

TEST_CASE("a long message is not wrapped, and a name beyond ASCII is shown in ASCII", "[callers]")
{
    const support::TemporaryFolder folder;
    const std::string name = "a_scene_whose_name_is_rather_long_\xC3\xA4\xC3\xB6\xC3\xBC_so_that_a_line_of_eighty_"
                             "columns_does_not_hold_it.pov";
    write_text(folder / name, std::string(kEmptyScene) + "#warning \"gr\xC3\xBC\xC3\x9F"
                                                         "e\"\nshpere { 0, 1 }\n");
    const Ended ended = run_program(folder.path(), WHITTLE_AS_POVRAY, {name, "-D"});
    CHECK(ended.status == 1);
    CHECK(support::ascii(ended.err));
    CHECK(std::regex_search(ended.err, std::regex("\nFile '[^'\n]{90,}' line 5: Parse Error: [^\n]+\n")));
}

TEST_CASE("a scene that includes itself writes at most 16 kB, and one that is absent is said to be", "[callers]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "x.pov",
               std::string(kEmptyScene) + "union { sphere { 0, 1 } }\n#warning \"again\"\n#include \"x.pov\"\n");
    const Ended ended = run_program(folder.path(), WHITTLE_AS_POVRAY, {"x.pov", "-D"});
    CHECK(ended.status == 1);
    CHECK(ended.err.size() < 16 * 1024);
    CHECK(std::regex_search(ended.err,
                            std::regex("\nFile 'x\\.pov' line 6: Parse Error: files include each other too deeply")));
    const Ended absent = run_program(folder.path(), WHITTLE_AS_POVRAY, {"+Inothere.pov", "-D"});
    CHECK(absent.status == 1);
    CHECK_THAT(absent.err, Catch::Contains("nothere.pov: error: there is no such file\n") &&
                               Catch::Contains("\nFatal error in parser: Cannot parse input.\nRender failed\n"));
}

TEST_CASE("options that cannot be understood end with status 1 at once, without a picture", "[callers]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "x.pov", kEmptyScene);
    for (const char* bad :
         {"+ZZ", "Widht=3", "Antialias=maybe", "+SR5 +ER2", "+A5", "--jsno", "nothing.ini", "+W", "+FX", "+ER0"}) {
        INFO(bad);
        const Ended ended = run_program(folder.path(), WHITTLE_AS_POVRAY, {"x.pov", bad, "+W8", "+H6"});
        CHECK(ended.status == 1);
        CHECK(ended.out.empty());
        CHECK_FALSE(std::filesystem::exists(folder / "x.png"));
    }
    CHECK(run_program(folder.path(), WHITTLE_AS_POVRAY, {}).status == 1);
    CHECK(run_program(folder.path(), WHITTLE_AS_POVRAY, {"missing.pov", "-D"}).status == 1);
}

TEST_CASE("a caller that ends the render gets status 2 and no picture", "[callers]")
{
    for (const int signal : {SIGINT, SIGTERM, SIGQUIT}) {
        const support::TemporaryFolder folder;
        write_text(folder / "x.pov", kEndless);
        RunningProgram program(folder.path(), WHITTLE_AS_POVRAY, {"x.pov", "-d", "+W1600", "+H1200", "+A0.0", "+R5"});
        while (program.error_so_far().find("Rendered ") == std::string::npos && program.running())
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        program.kill(signal);
        const Ended ended = program.wait();
        INFO(ended.err);
        CHECK(ended.status == 2);
        CHECK_THAT(ended.err, Catch::Contains("\nRender cancelled by user\n"));
        CHECK_FALSE(std::filesystem::exists(folder / "x.png"));
    }
}

TEST_CASE("a caller that ends the reading of a scene gets status 2, and its command is run", "[callers]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "x.pov", "#debug \"reading\\n\"\n#declare I = 0;\n#while (I >= 0) #declare I = I + 1; #end\n");
    write_text(folder / "x.ini", "Input_File_Name=x.pov\nUser_Abort_Command=touch told\n");
    RunningProgram program(folder.path(), WHITTLE_AS_POVRAY, {"x.ini", "--allow-commands"});
    while (program.error_so_far().find("reading") == std::string::npos && program.running())
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    program.kill(SIGINT);
    const Ended ended = program.wait();
    INFO(ended.err);
    CHECK(ended.status == 2);
    CHECK(std::filesystem::exists(folder / "told"));
    CHECK_THAT(ended.err, Catch::Contains("\n x.pov:3:1: note: reading is cancelled, in this loop\n"));
}

TEST_CASE("a caller that never reads what is written does not hold the render up", "[callers]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "x.pov", kEmptyScene);
    write_text(folder / "x.pov.ini", "Input_File_Name=x.pov\nWidth=320\nHeight=240\nRender_Block_Size=4\nDisplay="
                                     "true\nPause_When_Done=true\nVerbose=true\n");
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    RunningProgram program(folder.path(), WHITTLE_AS_POVRAY, {"x.pov.ini"}, "", ends[1]);
    CHECK(program.wait().status == 0);
    CHECK(std::filesystem::exists(folder / "x.png"));
    RunningProgram animation(folder.path(), WHITTLE_AS_POVRAY, {"x.pov.ini", "+KFF20"}, "", ends[1]);
    CHECK(animation.wait().status == 0);
    CHECK(std::filesystem::exists(folder / "x20.png"));
    close(ends[0]);
    close(ends[1]);
}

TEST_CASE("the version is told on standard error, in one line that names POV-Ray and says that it is not official",
          "[callers]")
{
    const support::TemporaryFolder folder;
    for (const char* word : {"--version", "-version", "--V"}) {
        const Ended ended = run_program(folder.path(), WHITTLE_AS_POVRAY, {word});
        CHECK(ended.status == 0);
        CHECK(ended.out.empty());
        CHECK(std::regex_search(ended.err, std::regex("(^|\n)[^\n]*POV-Ray[^\n]*official")));
    }
}

TEST_CASE("LeoCAD watches the picture grow in a mapped file", "[callers]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "x.pov", std::string(kEmptyScene) + "background { rgb <1, 0, 1> }\n");
    CHECK(run_program(folder.path(), WHITTLE_AS_POVRAY, {"+I\"x.pov\"", "+W20", "+H10", "+SM\"map\"", "-F"}).status ==
          0);
    const std::string map = support::text_of(folder / "map");
    REQUIRE(map.size() == 20 + 4 * 20 * 10);
    std::uint32_t header[5];
    std::memcpy(header, map.data(), sizeof header);
    CHECK(header[1] == 20);
    CHECK(header[2] == 10);
    CHECK(header[3] == 200);  // pixels in place
    for (std::size_t i = 20; i < map.size(); i += 4) REQUIRE(map.substr(i, 4) == std::string("\xFF\0\xFF\xFF", 4));
}

TEST_CASE("the benchmark tells its time, and asks no key", "[callers]")
{
    const support::TemporaryFolder folder;
    const Ended ended = run_program(folder.path(), WHITTLE_AS_POVRAY, {"-benchmark", "+W48", "+H48"}, "1\n");
    INFO(ended.err);
    if (ended.status == 0) {
        CHECK(std::regex_search(ended.err, std::regex("\n  Trace Time: .*\\(\\d+\\.\\d+ seconds\\)\n")));
    } else {  // the scene is in a package of its own
        CHECK(ended.status == 1);
        CHECK_THAT(ended.err, Catch::Contains("the benchmark scene is not installed"));
    }
    CHECK(folder.names().empty());
}

TEST_CASE("other names of the program than povray speak Whittle's words, unless told", "[callers]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "x.pov", kEmptyScene);
    std::filesystem::create_symlink(std::filesystem::canonical(WHITTLE_AS_POVRAY), folder / "povray-3.7");
    const auto finished = [&](const std::string& program, const std::vector<std::string>& words) {
        return run_program(folder.path(), program, words).err.find("POV-Ray finished\n") != std::string::npos;
    };
    CHECK(finished(folder / "povray-3.7", {"x.pov", "+W8", "+H6"}));
    CHECK_FALSE(finished(std::filesystem::canonical(WHITTLE_AS_POVRAY), {"x.pov", "+W8", "+H6"}));
    CHECK(finished(std::filesystem::canonical(WHITTLE_AS_POVRAY), {"x.pov", "+W8", "+H6", "--console=povray"}));
    CHECK_FALSE(finished(folder / "povray-3.7", {"x.pov", "+W8", "+H6", "--quiet"}));
}
