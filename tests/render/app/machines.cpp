// What editors, build tools and farms read: JSON of a run, the files of a scene, a check without a render, exit
// statuses.
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>

namespace {

using support::Ended;
using support::run_program;
using support::text_of;
using support::write_text;
using Words = std::vector<std::string>;

constexpr const char* kTwoFileScene = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#include "
                                      "\"part.inc\"\ncamera { location -z*4 }\nsphere { 0, Size pigment { rgb 1 } }\n";

void make_scene(const support::TemporaryFolder& folder)
{
    write_text(folder / "a.pov", kTwoFileScene);
    write_text(folder / "part.inc", "#declare Size = 1;\n#warning \"from the part\"\n");
    write_text(folder / "a.ini", "Width=8\nHeight=6\nDeclare=n=3\n");
}

/// The value behind a key, as it stands in JSON of one line a value.
std::string value_of(const std::string& json, const std::string& key)
{
    const std::size_t at = json.find("\"" + key + "\": ");
    if (at == std::string::npos) return "(none)";
    const std::size_t begin = at + key.size() + 4, end = json.find_first_of(",\n", begin);
    return json.substr(begin, end - begin);
}

/// Python's reader of JSON, where there is Python, accepts the text.
void check_json(const support::TemporaryFolder& folder, const std::string& name)
{
    if (!std::filesystem::exists("/usr/bin/python3")) return;
    CHECK(run_program(folder.path(), "/usr/bin/python3", {"-m", "json.tool", name}).status == 0);
}

}  // namespace

TEST_CASE("--json tells options, phases, counts, memory, messages and the picture", "[program][machines]")
{
    const support::TemporaryFolder folder;
    make_scene(folder);
    REQUIRE(run_program(folder.path(), WHITTLE_PROGRAM, {"a.ini", "a.pov", "--json", "run.json"}).status == 0);
    check_json(folder, "run.json");
    const std::string json = text_of(folder / "run.json");
    CHECK(value_of(json, "exit_status") == "0");
    CHECK(value_of(json, "result") == "\"done\"");
    CHECK(value_of(json, "Width") == "\"8\"");
    CHECK(value_of(json, "camera_rays") == "48");
    CHECK(value_of(json, "picture") == "\"a.png\"");
    CHECK(value_of(json, "severity") == "\"warning\"");
    CHECK(value_of(json, "line") == "2");
    CHECK(value_of(json, "text") == "\"from the part\"");
    CHECK(std::stod(value_of(json, "trace_seconds")) >= 0.0);
    CHECK(std::stod(value_of(json, "trace_cpu_seconds")) > 0.0);
    CHECK(std::stoll(value_of(json, "peak_memory_bytes")) > 1'000'000);
}

TEST_CASE("--json is written for a run that fails too, and carries any text", "[program][machines]")
{
    const support::TemporaryFolder folder;
    make_scene(folder);
    write_text(folder / "bad.pov", "#debug \"a \\\"quote\\\", \t a tab, \xC3\xA4 and \xFF\\n\"\nshpere { }\n");
    CHECK(run_program(folder.path(), WHITTLE_PROGRAM, {"bad.pov", "--json=run.json"}).status == 1);
    check_json(folder, "run.json");
    const std::string json = text_of(folder / "run.json");
    CHECK(value_of(json, "exit_status") == "1");
    CHECK(value_of(json, "result") == "\"failed\"");
    CHECK(json.find("'shpere' is not declared; did you mean 'sphere'?") != std::string::npos);
    CHECK(run_program(folder.path(), WHITTLE_PROGRAM, {"a.pov", "--json", "options.json", "+ZZ"}).status == 1);
    check_json(folder, "options.json");
    CHECK(text_of(folder / "options.json").find("unknown switch '+ZZ'") != std::string::npos);
    const Ended out = run_program(folder.path(), WHITTLE_PROGRAM, {"a.pov", "+W8", "+H6", "--json", "-"});
    CHECK(out.out.starts_with("{\n"));
    CHECK(out.out.ends_with("}\n"));
}

TEST_CASE("--deps prints the files that a picture is made of", "[program][machines]")
{
    const support::TemporaryFolder folder;
    make_scene(folder);
    const Ended ended = run_program(folder.path(), WHITTLE_PROGRAM, {"a.ini", "a.pov", "--deps"});
    CHECK(ended.status == 0);
    // The INI file of the system may stand first.
    CHECK(ended.out.ends_with("a.ini\na.pov\npart.inc\n"));
    CHECK(folder.names() == Words{"a.ini", "a.pov", "part.inc"});
}

TEST_CASE("--check reads a scene and tells its errors, and makes no file", "[program][machines]")
{
    const support::TemporaryFolder folder;
    make_scene(folder);
    const Ended good = run_program(folder.path(), WHITTLE_PROGRAM, {"a.pov", "--check"});
    CHECK(good.status == 0);
    CHECK(good.err.starts_with("part.inc:2:"));  // the warning
    write_text(folder / "bad.pov", "shpere { }\n");
    const Ended bad = run_program(folder.path(), WHITTLE_PROGRAM, {"bad.pov", "--check"});
    CHECK(bad.status == 1);
    CHECK_THAT(bad.err, Catch::Contains("bad.pov:1:1: error: 'shpere' is not declared"));
    CHECK(folder.names() == Words{"a.ini", "a.pov", "bad.pov", "part.inc"});
}

TEST_CASE("--werror ends a run that warns; --quiet leaves only errors", "[program][machines]")
{
    const support::TemporaryFolder folder;
    make_scene(folder);
    CHECK(run_program(folder.path(), WHITTLE_PROGRAM, {"a.pov", "+W8", "+H6", "--werror"}).status == 1);
    CHECK_FALSE(std::filesystem::exists(folder / "a.png"));
    const Ended quiet = run_program(folder.path(), WHITTLE_PROGRAM, {"a.pov", "+W8", "+H6", "--quiet"});
    CHECK(quiet.status == 0);
    CHECK(quiet.err.empty());
    write_text(folder / "bad.pov", "shpere { }\n");
    CHECK_THAT(run_program(folder.path(), WHITTLE_PROGRAM, {"bad.pov", "--quiet"}).err, Catch::Contains("error:"));
}

TEST_CASE("what POV-Ray leaves out as too far is told once a run, and left out on demand", "[program][machines]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "far.pov", "#version 3.7; global_settings { assumed_gamma 1 } camera { location 0 look_at z }"
                                   "sphere { <0,0,1.3e7>, 2e6 pigment { rgb 1 } finish { ambient 1 } }");
    const auto far_notes = [&](const Words& more) {
        Words words{"far.pov", "+W16", "+H12"};
        words.insert(words.end(), more.begin(), more.end());
        const Ended ended = run_program(folder.path(), WHITTLE_PROGRAM, words);
        CHECK(ended.status == 0);
        std::size_t found = 0;
        for (std::size_t at = ended.err.find("1e7"); at != std::string::npos; at = ended.err.find("1e7", at + 1))
            ++found;
        return found;
    };
    CHECK(far_notes({}) == 1);
    CHECK(far_notes({"+KFF3"}) == 1);
    CHECK(far_notes({"--faithful"}) == 0);
}

TEST_CASE("a missing folder of the picture is named before the scene is read, and made on demand",
          "[program][machines]")
{
    const support::TemporaryFolder folder;
    make_scene(folder);
    const Ended missing = run_program(folder.path(), WHITTLE_PROGRAM, {"a.pov", "+W8", "+H6", "+Onew/deep/x.png"});
    CHECK(missing.status == 1);
    CHECK_THAT(missing.err, Catch::Contains("there is no folder 'new/deep' (--make-folders makes it)"));
    CHECK_THAT(missing.err, !Catch::Contains("from the part"));
    CHECK(run_program(folder.path(), WHITTLE_PROGRAM, {"a.pov", "+W8", "+H6", "+Onew/deep/x.png", "--make-folders"})
              .status == 0);
    CHECK(std::filesystem::exists(folder / "new/deep/x.png"));
}

TEST_CASE("streams go to files beside the picture; Create_Ini gives the run again", "[program][machines]")
{
    const support::TemporaryFolder folder;
    make_scene(folder);
    std::filesystem::create_directory(folder / "out");
    REQUIRE(run_program(folder.path(), WHITTLE_PROGRAM,
                        {"a.pov", "+W8", "+H6", "+FN16", "+Oout/", "+GWwarn.txt", "Statistic_File=on", "+GAall.txt",
                         "+GIagain.ini"})
                .status == 0);
    CHECK_THAT(text_of(folder / "out/warn.txt"), Catch::Contains("from the part") && !Catch::Contains("camera"));
    CHECK_THAT(text_of(folder / "out/stats.out"), Catch::Contains("camera 48"));
    CHECK_THAT(text_of(folder / "out/all.txt"), Catch::Contains("from the part") && Catch::Contains("camera 48"));
    CHECK(run_program(folder.path(), WHITTLE_PROGRAM, {"a.pov", "+GAout/x.txt"}).status ==
          1);  // the picture's folder only
    const std::string picture = text_of(folder / "out/a.png");
    std::filesystem::remove(folder / "out/a.png");
    REQUIRE(run_program(folder.path(), WHITTLE_PROGRAM, {"again.ini"}).status == 0);
    CHECK(text_of(folder / "out/a.png") == picture);
}

TEST_CASE("a scene comes from standard input", "[program][machines]")
{
    const support::TemporaryFolder folder;
    make_scene(folder);
    for (const char* input : {"+I-", "+Istdin", "Input_File_Name=-"}) {
        const Ended ended = run_program(folder.path(), WHITTLE_PROGRAM, {input, "+W8", "+H6", "+O-"}, kTwoFileScene);
        CHECK(ended.status == 0);
        CHECK(ended.out.starts_with("\x89PNG"));
    }
    CHECK(run_program(folder.path(), WHITTLE_PROGRAM, {"+I-", "+W8", "+H6"}, kTwoFileScene).status == 0);
    CHECK(std::filesystem::exists(folder / "stdin.png"));
}
