// Pictures that memory does not hold are rendered in strips, to the same bytes; what fits nowhere is refused before
// anything is read.
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <regex>

namespace {

using support::Ended;
using support::RunningProgram;
using support::run_program;
using support::text_of;
using support::write_text;
using Words = std::vector<std::string>;

constexpr const char* kScene =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0, 0, -4> look_at 0 }\nlight_source { <-5, "
    "5, -5>, 1 }\n"
    "plane { y, -1 pigment { granite } }\nsphere { 0, 1 pigment { rgb <1, 0.5, 0.25> } finish { reflection 0.5 } }\n";

Words joined(Words words, const Words& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// Bytes that the process had at most.
double peak_memory(const support::TemporaryFolder& folder, const Words& words)
{
    const Ended ended = run_program(folder.path(), WHITTLE_PROGRAM, joined(words, {"--json=-", "--quiet"}));
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    std::smatch found;
    REQUIRE(std::regex_search(ended.out, found, std::regex("\"peak_memory_bytes\": *(\\d+)")));
    return std::stod(found[1]);
}

}  // namespace

TEST_CASE("a picture in strips has the bytes of one made as a whole", "[large]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "s.pov", kScene);
    // 120 pixels of 16 bytes, 16 rows: 31 kB a strip of one row of blocks.
    const Words size{"s.pov", "+W120", "+H90", "+BS16"};
    const Words kinds[] = {{"+FN"},
                           {"+FN16", "+UA"},
                           {"+FNg"},
                           {"+FN", "Dither=on", "Dither_Method=FS"},
                           {"+FP"},
                           {"+FP16"},
                           {"+FE"},
                           {"+FE", "+UA"},
                           {"+FH"},
                           {"+FJ"},
                           {"+FT", "+UA"},
                           {"+FC"},
                           {"+FN", "+A0.1", "+AM1"},
                           {"+FN", "+A0.1", "+AM2", "+R3"},
                           {"+FN", "+SR21", "+ER70", "+SC13", "+EC99"}};
    bool narrow = false;
    for (const Words& kind : kinds) {
        INFO(kind.front() << ' ' << kind.back());
        narrow = !narrow;  // strips of one row of blocks, and of two
        REQUIRE(run_program(folder.path(), WHITTLE_PROGRAM, joined(joined(size, kind), {"+Owhole"})).status == 0);
        const Ended ended =
            run_program(folder.path(), WHITTLE_PROGRAM,
                        joined(joined(size, kind), {"+Ostrips", narrow ? "--memory=0.035" : "--memory=0.07"}));
        INFO(ended.err);
        REQUIRE(ended.status == 0);
        const Words names = folder.names();
        REQUIRE(names.size() == 3);
        CHECK(text_of(folder / names[1]) == text_of(folder / names[2]));
        CHECK(std::filesystem::file_size(folder / names[1]) > 500);
        for (const std::string& name : {names[1], names[2]}) std::filesystem::remove(folder / name);
    }
    const Words streamed = joined(size, {"+O-", "+FN"});
    CHECK(run_program(folder.path(), WHITTLE_PROGRAM, joined(streamed, {"--memory=0.035"})).out ==
          run_program(folder.path(), WHITTLE_PROGRAM, streamed).out);
}

TEST_CASE("a picture in strips that was interrupted goes on with +C", "[large]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "s.pov", kScene);
    const Words words{"s.pov", "+W400", "+H300", "+BS16", "+A0.05", "+AM2", "+R4", "--memory=0.3", "--state-after=0"};
    REQUIRE(run_program(folder.path(), WHITTLE_PROGRAM, joined(words, {"+Owhole.png", "--memory=100"})).status == 0);
    bool interrupted = false;
    for (const int signal : {SIGKILL, SIGTERM}) {
        for (int i = 0; i < 20 && !interrupted; ++i) {  // a busy machine may let it finish first
            std::filesystem::remove(folder / "s.png");
            RunningProgram program(folder.path(), WHITTLE_PROGRAM, words);
            std::error_code error;
            while (program.running() &&
                   (std::filesystem::file_size(folder / "s.whittle-state", error) < 600'000 || error))
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            program.kill(signal);
            interrupted = program.wait().status != 0 && std::filesystem::exists(folder / "s.whittle-state");
        }
        REQUIRE(interrupted);
        CHECK(std::filesystem::exists(folder / "s.partial.png") == (signal == SIGTERM));
        const Ended continued = run_program(folder.path(), WHITTLE_PROGRAM, joined(words, {"+C"}));
        INFO(continued.err);
        CHECK(continued.status == 0);
        CHECK_THAT(continued.err, Catch::Contains("blocks taken from"));
        CHECK(text_of(folder / "s.png") == text_of(folder / "whole.png"));
        for (const std::string& name : folder.names())  // but for what a killed process had begun
            if (name.ends_with(".part")) std::filesystem::remove(folder / name);
        CHECK(folder.names() == Words{"s.png", "s.pov", "whole.png"});
        interrupted = false;
    }
}

TEST_CASE("what cannot fit is refused at once, with a sentence", "[large]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "s.pov", std::string("#while (1) #end\n"));  // not read
    const auto refused = [&](const Words& words, const std::string& sentence) {
        const Ended ended = run_program(folder.path(), WHITTLE_PROGRAM, joined({"s.pov"}, words));
        INFO(ended.err);
        CHECK(ended.status == 1);
        CHECK_THAT(ended.err, Catch::Contains(sentence));
        CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
        CHECK(ended.cpu_seconds < 0.1);
        CHECK(folder.names() == Words{"s.pov"});
    };
    refused({"+W1000000", "+H1000000", "+FP"},
            "a picture of 1000000x1000000 takes at least 3.0 TB on disk, and there is room for ");
    refused({"+W50000", "+H50000", "+FB", "--memory=1000"},
            "a picture of 50000x50000 takes 40.0 GB of memory, and 1.0 GB may be used: a BMP cannot grow row by row");
    refused({"+W70000", "+H50", "+FJ"},
            "a picture of 70000x50 does not fit into this output file type, whose sides are at most 65500");
    refused({"+W50000", "+H50000", "--memory=20"},
            "a row of blocks of a picture of 50000x50000 takes 25.6 MB of memory, and 20.0 MB may be used");
}

TEST_CASE("beyond the picture itself a render takes less than 8 bytes a pixel, and in strips no more than was allowed",
          "[large]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "s.pov", "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb 0.5 }\n");
    constexpr double kPixels = 2000.0 * 1500.0, kPicture = 16.0;
    const Words size{"+W2000", "+H1500"};
    for (const char* type : {"+FN", "+FN16", "+FP", "+FE", "+FB"}) {
        INFO(type);
        const Words words{"s.pov", "-D", type, "Dither=on"};
        const double program = peak_memory(folder, joined(words, {"+W64", "+H48"})),
                     whole = peak_memory(folder, joined(words, size));
        CHECK((whole - program) / kPixels < kPicture + 8.0);
        if (std::string(type) == "+FB") continue;
        // A strip of 8 MB and a partial picture of every fourth pixel (12 MB); the rest is what the heap keeps and the
        // file's library buffers: 1 to 8.4 MB, measured on two machines with all types. Half of what the whole picture
        // may take is the bound.
        const double strips = peak_memory(folder, joined(joined(words, size), {"--memory=8"})) - program;
        CHECK(strips < 0.5 * (kPicture + 8.0) * kPixels);
    }
}
