// A render that ends early, by a signal that asks or one that does not, goes on with +C: what was finished is not
// traced again, and the picture is that of a run from start to end, byte for byte.
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <regex>

namespace {

using support::Ended;
using support::RunningProgram;
using support::text_of;
using support::write_text;
using Words = std::vector<std::string>;

/// Some tenths of a second: an area light of 49 samples.
constexpr const char* kSlowScene =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0, 0, -4> look_at 0 }\n"
    "light_source { <-5, 5, -5>, 1 area_light x*3, y*3, 7, 7 }\nplane { y, -1 pigment { granite } finish { reflection "
    "0.3 } }\n"
    "sphere { 0, 1 pigment { rgb <1, 0.5, 0.25> } finish { reflection 0.5 } }\n";

const Words kWhole{"s.pov", "+W200", "+H152", "+BS8"};

Words with(Words words, const Words& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::uintmax_t size_of(const std::string& path)
{
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    return error ? 0 : size;
}

/// Starts a render and sends the signal once some blocks of the picture `name` are on disk. A busy machine may let it
/// finish before: then once more.
Ended interrupted(const support::TemporaryFolder& folder, int signal, const Words& words = kWhole,
                  const std::string& name = "s")
{
    constexpr int kMostTries = 20;
    for (int i = 0; i < kMostTries; ++i) {
        RunningProgram program(folder.path(), WHITTLE_PROGRAM, with(words, {"--state-after=0"}));
        while (size_of(folder / (name + ".whittle-state")) < 20'000 && program.running())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        program.kill(signal);
        const Ended ended = program.wait();
        if (std::filesystem::exists(folder / (name + ".whittle-state"))) return ended;
        std::filesystem::remove(folder / (name + ".png"));
    }
    return {};
}

/// Blocks that a continued run says it took over.
int taken_over(const std::string& text)
{
    std::smatch found;
    return std::regex_search(text, found, std::regex("note: (\\d+) of \\d+ blocks taken from")) ? std::stoi(found[1])
                                                                                                : 0;
}

}  // namespace

TEST_CASE("an interrupted render goes on where it was, to the same bytes", "[continue]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "s.pov", kSlowScene);
    REQUIRE(support::run_program(folder.path(), WHITTLE_PROGRAM, with(kWhole, {"+Owhole.png"})).status == 0);
    const std::string whole = text_of(folder / "whole.png");
    for (const int signal : {SIGKILL, SIGINT, SIGTERM}) {
        INFO("signal " << signal);
        const Ended ended = interrupted(folder, signal);
        CHECK(ended.status == (signal == SIGKILL ? -SIGKILL : 2));
        REQUIRE(size_of(folder / "s.whittle-state") > 0);
        CHECK_FALSE(std::filesystem::exists(folder / "s.png"));
        const Ended continued = support::run_program(folder.path(), WHITTLE_PROGRAM, with(kWhole, {"+C"}));
        INFO(continued.err);
        CHECK(continued.status == 0);
        CHECK(taken_over(continued.err) >= 10);
        CHECK(text_of(folder / "s.png") == whole);
        CHECK(folder.names() == Words{"s.png", "s.pov", "whole.png"});  // the state is gone
        std::filesystem::remove(folder / "s.png");
    }
}

TEST_CASE("an animation goes on with the frame that was interrupted", "[continue]")
{
    const Words frames = with(kWhole, {"+KFF3"});
    const support::TemporaryFolder folder, other;
    for (const auto* place : {&folder, &other})
        write_text(*place / "s.pov",
                   std::string(kSlowScene) + "cylinder { 0, y*(clock + 1), 0.3 pigment { rgb 1 } }\n");
    REQUIRE(support::run_program(other.path(), WHITTLE_PROGRAM, frames).status == 0);
    interrupted(folder, SIGKILL, frames, "s2");
    std::filesystem::remove(folder / "s3.png");  // of an earlier try
    REQUIRE(folder.names() == Words{"s.pov", "s1.png", "s2.whittle-state"});
    const auto first = std::filesystem::last_write_time(folder / "s1.png");
    const Ended continued = support::run_program(folder.path(), WHITTLE_PROGRAM, with(frames, {"+C"}));
    INFO(continued.err);
    CHECK(continued.status == 0);
    CHECK(taken_over(continued.err) >= 10);
    CHECK(std::filesystem::last_write_time(folder / "s1.png") == first);
    for (const char* name : {"s1.png", "s2.png", "s3.png"}) CHECK(text_of(folder / name) == text_of(other / name));
    CHECK(folder.names() == other.names());
}

TEST_CASE("a state file that was cut short or damaged loses no more than the blocks it hit", "[continue]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "s.pov", kSlowScene);
    REQUIRE(support::run_program(folder.path(), WHITTLE_PROGRAM, with(kWhole, {"+Owhole.png"})).status == 0);
    interrupted(folder, SIGKILL);
    const std::string path = folder / "s.whittle-state";
    std::string state = text_of(path);
    REQUIRE(state.size() > 10'000);
    state.resize(9'000);
    state[8'000] = static_cast<char>(~state[8'000]);
    write_text(path, state);
    const Ended continued = support::run_program(folder.path(), WHITTLE_PROGRAM, with(kWhole, {"+C"}));
    CHECK(taken_over(continued.err) == 7);  // 48 bytes of heading, then 1040 for a block of 8x8
    CHECK(text_of(folder / "s.png") == text_of(folder / "whole.png"));
}

TEST_CASE("a state of another scene or of other options is not used", "[continue]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "s.pov", kSlowScene);
    interrupted(folder, SIGKILL);
    const std::string state = text_of(folder / "s.whittle-state");
    const auto says_other = [&](const Words& words) {
        write_text(folder / "s.whittle-state", state);
        std::filesystem::remove(folder / "s.png");
        return support::run_program(folder.path(), WHITTLE_PROGRAM, with(words, {"+C"}))
                   .err.find("is of another picture or of other options") != std::string::npos;
    };
    CHECK(says_other(with(kWhole, {"+A0.2"})));
    CHECK(says_other(with(kWhole, {"+K0.5"})));
    CHECK(says_other(with(kWhole, {"Declare=x0=3"})));
    write_text(folder / "s.pov", std::string(kSlowScene) + "\n// more\n");
    CHECK(says_other(kWhole));
}

TEST_CASE("without +C a picture that is there is made anew; with it, it is left", "[continue]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "s.pov", "camera { location -z }");
    write_text(folder / "s.png", "there");
    REQUIRE(support::run_program(folder.path(), WHITTLE_PROGRAM, {"s.pov", "+W8", "+H6", "+C"}).status == 0);
    CHECK(text_of(folder / "s.png") == "there");
    REQUIRE(support::run_program(folder.path(), WHITTLE_PROGRAM, {"s.pov", "+W8", "+H6"}).status == 0);
    CHECK(text_of(folder / "s.png").starts_with("\x89PNG"));
    write_text(folder / "s.png", "");  // empty: as good as not there
    REQUIRE(support::run_program(folder.path(), WHITTLE_PROGRAM, {"s.pov", "+W8", "+H6", "+C"}).status == 0);
    CHECK(text_of(folder / "s.png").starts_with("\x89PNG"));
}
