// Commands around frames and scenes (reference manual 3.2.6): their order, what replaces %o and its kin, and what their
// exit status does. They run only with --allow-commands.
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

namespace {

using support::Ended;
using support::text_of;
using support::write_text;

constexpr const char* kEmptyScene = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -z }\n";

/// All six commands leave a line in the file `log`.
constexpr const char* kCommands =
    "Pre_Scene_Command=echo prescene %s %o %w %h >>log\nPre_Frame_Command=echo preframe %n %k %o >>log\n"
    "Post_Frame_Command=echo postframe %n 100%% >>log\nPost_Scene_Command=echo postscene >>log\n"
    "User_Abort_Command=echo abort >>log\nFatal_Error_Command=echo fatal >>log\n";

struct Outcome {
    int status;
    std::string log;
};

Outcome outcome(const std::string& ini, const char* scene = kEmptyScene, const char* options = "+KFF2 --allow-commands")
{
    const support::TemporaryFolder folder;
    write_text(folder / "a.pov", scene);
    write_text(folder / "c.ini", kCommands + ini);
    std::vector<std::string> words{"c.ini", "a.pov", "+W4", "+H3"};
    for (std::istringstream more(options); more >> words.emplace_back();) {}
    words.pop_back();
    const Ended ended = support::run_program(folder.path(), WHITTLE_PROGRAM, words);
    INFO(ended.err);
    CHECK(ended.out.empty());
    return {ended.status, text_of(folder / "log")};
}

}  // namespace

TEST_CASE("commands run around the scene and each frame", "[program][commands]")
{
    const Outcome ran = outcome("");
    CHECK(ran.status == 0);
    CHECK(ran.log == "prescene a a.png 4 3\npreframe 1 0 a1.png\npostframe 1 100%\npreframe 2 1 a2.png\npostframe 2 "
                     "100%\npostscene\n");
}

TEST_CASE("commands do not run unless allowed", "[program][commands]")
{
    const Outcome ran = outcome("", kEmptyScene, "+KFF2");
    CHECK(ran.status == 0);
    CHECK(ran.log.empty());
}

TEST_CASE("the exit status of a command acts as its return action says", "[program][commands]")
{
    const std::string begin = "prescene a a.png 4 3\n", one = "preframe 1 0 a1.png\npostframe 1 100%\n";
    const auto check = [](const char* ini, int status, const std::string& log) {
        INFO(ini);
        const Outcome ran = outcome(ini);
        CHECK(ran.status == status);
        CHECK(ran.log == log);
    };
    check("Pre_Scene_Return=-S\n", 0, begin + "postscene\n");
    check("Pre_Scene_Return=-A\n", 0, begin);
    check("Pre_Scene_Return=-Q\n", 0, begin);
    check("Pre_Scene_Return=!U\n", 2, begin + "abort\n");
    check("Pre_Scene_Return=-F\n", 1, begin + "fatal\n");
    check("Pre_Scene_Return=F\n", 0,
          begin + one + "preframe 2 1 a2.png\npostframe 2 100%\npostscene\n");  // its status was 0
    check("Pre_Frame_Return=-S\n", 0, begin + "preframe 1 0 a1.png\npreframe 2 1 a2.png\npostscene\n");
    check("Pre_Frame_Return=-A\n", 0, begin + "preframe 1 0 a1.png\npostscene\n");
    check("Post_Frame_Return=-S\n", 0, begin + one + "postscene\n");
    check("Post_Frame_Return=-Q\n", 0, begin + one);
    check("Post_Scene_Return=-F\n", 1, begin + one + "preframe 2 1 a2.png\npostframe 2 100%\npostscene\nfatal\n");
    check("Pre_Frame_Return=-U\nUser_Abort_Return=-F\n", 1, begin + "preframe 1 0 a1.png\nabort\nfatal\n");
    check("Pre_Frame_Command=exit 3\nPre_Frame_Return=F\n", 1, begin + "fatal\n");
}

TEST_CASE("an error in the scene runs the command for errors", "[program][commands]")
{
    const Outcome ran = outcome("", "shpere { }");
    CHECK(ran.status == 1);
    CHECK(ran.log == "prescene a a.png 4 3\npreframe 1 0 a1.png\nfatal\n");
}
