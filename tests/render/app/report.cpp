// whittle report: docs/error_and_time.md.
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <unistd.h>

#include <filesystem>

using support::run_program;

TEST_CASE("a report is a page, CSV and JSON, and tells what could not be measured", "[program][report]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "s.pov", "#version 3.7; global_settings { assumed_gamma 1 }\n"
                                          "camera { location -4*z look_at 0 } light_source { <3,5,-5> rgb 1 }\n"
                                          "sphere { 0, 1 pigment { rgb 1 } }\n");
    support::write_text(folder / "bad.pov", "#version 3.7;\nspere { 0, 1 }\n");
    const auto ended = run_program(folder.path(), WHITTLE_PROGRAM,
                                   {"report", "s.pov", "bad.pov", "-o", "r.html", "+W16", "+H12", "--povray=off",
                                    "--truth-error=1", "--truth-seconds=2"});
    CHECK(ended.status == 1);
    CHECK(ended.err.find("bad.pov:2:1: error:") != std::string::npos);
    const std::string page = support::text_of(folder / "r.html"), csv = support::text_of(folder / "r.csv");
    CHECK(page.find("<svg") != std::string::npos);
    CHECK(page.find("Not measured: bad.pov:2:1") != std::string::npos);
    CHECK(csv.find("\"s.pov\",whittle,\"samples\",\"--samples=16\"") != std::string::npos);
    CHECK(csv.find("area") == std::string::npos);
    CHECK(run_program(folder.path(), "/usr/bin/python3", {"-m", "json.tool", "r.json"}).status == 0);
    CHECK(!std::filesystem::exists(folder / "r.html.picture.png"));
}

TEST_CASE("a report that cannot be written or is not understood says so before it measures", "[program][report]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "s.pov", "sphere { 0, 1 }\n");
    const auto refused = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"report", "s.pov"});
        const auto ended = run_program(folder.path(), WHITTLE_PROGRAM, words);
        CHECK(ended.status == 1);
        return ended.err;
    };
    CHECK(refused({"-o", "no/such/folder/r.html"}).find("there is no folder") != std::string::npos);
    std::filesystem::create_directory(folder / "locked");
    CHECK(refused({"-o", "locked"}).find("cannot write 'locked': it is a folder") != std::string::npos);
    // Modes do not keep root out; nobody makes files in /proc.
    std::filesystem::permissions(folder / "locked",
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    for (const std::string& place : {folder / "locked/r.html", std::string("/proc/r.html")}) {
        if (geteuid() == 0 && place.find("/proc") != 0) continue;
        CHECK(refused({"-o", place}).find("cannot write '" + place + "': ") != std::string::npos);
    }
    CHECK(folder.names() == std::vector<std::string>{"locked", "s.pov"});
    CHECK(refused({"--want=0"}).find("--want wants a number above 0") != std::string::npos);
    CHECK(refused({"--truth-seconds"}).find("wants a value") != std::string::npos);
    CHECK(refused({"--nonsense"}).find("unknown option") != std::string::npos);
    CHECK(run_program(folder.path(), WHITTLE_PROGRAM, {"report"}).err.find("no scene given") != std::string::npos);
}

TEST_CASE("POV-Ray looks for includes beside the scene too", "[program][report]")
{
    const support::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "scenes");
    support::write_text(folder / "scenes/part.inc", "sphere { 0, 1 pigment { rgb 1 } }\n");
    support::write_text(folder / "scenes/s.pov", "#version 3.7; global_settings { assumed_gamma 1 }\n"
                                                 "camera { location -4*z look_at 0 } light_source { <3,5,-5> rgb 1 }\n"
                                                 "#include \"part.inc\"\n");
    // What stands for POV-Ray keeps what it is called with, and fails.
    support::write_text(folder / "povray", "#!/bin/sh\n"
                                           "[ \"$1\" = --version ] && echo POV-Ray 3.7.0 && exit 0\n"
                                           "for w in \"$@\"; do echo \"$w\" >> called.txt; done; exit 1\n");
    std::filesystem::permissions(folder / "povray", std::filesystem::perms::owner_all);
    const auto ended = run_program(
        folder.path(), WHITTLE_PROGRAM,
        {"report", "scenes/s.pov", "+W16", "+H12", "--povray=./povray", "--truth-error=1", "--truth-seconds=2"});
    CHECK(ended.status == 0);
    CHECK(support::text_of(folder / "called.txt").find("+L" + (folder / "scenes") + "\n") != std::string::npos);
}
