// A signal ends a run at once, whatever it is at; what is done is kept for +C and to look at.
#include "render/image/files.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <random>

namespace {

using support::Ended;
using support::RunningProgram;
using support::text_of;
using support::write_text;
using Clock = std::chrono::steady_clock;

constexpr const char* kHead = "#version 3.7;\n#include \"functions.inc\"\nglobal_settings { assumed_gamma 1 "
                              "max_trace_level 20 }\ncamera { location <0, 0, -4> look_at 0 }\n";

struct Stopped {
    Ended ended;
    double seconds, cpu_seconds;  ///< from the signal to the end
};

Stopped stop(RunningProgram& program, int signal)
{
    const double used = program.cpu_seconds();
    const Clock::time_point sent = Clock::now();
    program.kill(signal);
    const Ended ended = program.wait();
    return {ended, std::chrono::duration<double>(Clock::now() - sent).count(), ended.cpu_seconds - used};
}

/// Half a second is promised. Where others want the processors too the end has to wait for its turn, so then its work
/// counts.
void check_at_once(const Stopped& stopped)
{
    INFO(stopped.seconds << " s after the signal, " << stopped.cpu_seconds << " s of work\n" << stopped.ended.err);
    CHECK((stopped.seconds < 0.5 || stopped.cpu_seconds < 0.25));
    CHECK(stopped.seconds < 5.0);
}

/// Every pixel is the whole picture's, or black: not done. At least so many are done.
void check_part_of(const std::string& partial, const std::string& whole, int least)
{
    const image::Picture a = image::Files().read(partial), b = image::Files().read(whole);
    REQUIRE((a.width == b.width && a.height == b.height && a.channels == b.channels));
    int done = 0, other = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const bool same = a.at(x, y) == b.at(x, y);
            const bool black = a.at(x, y) == std::array<float, 4>{};
            done += same && !black;
            other += !same && !black;
        }
    CHECK(other == 0);
    CHECK(done >= least);
}

}  // namespace

TEST_CASE("20 signals at random moments: the run ends at once, and +C goes on to the same bytes", "[cancel]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "s.pov",
               std::string(kHead) +
                   "background { rgb <0.2, 0.3, 0.4> }\nlight_source { <-5, 5, -5>, 1 area_light x*3, y*3, 2, 2 "
                   "}\nplane { y, -1 pigment { checker rgb 0.2 rgb 1 } finish { reflection 0.3 } }\n"
                   "sphere { 0, 1 pigment { rgb <1, 0.5, 0.25> } finish { reflection 0.5 } }\n");
    const std::vector<std::string> words{"s.pov", "+W64", "+H48", "+BS8", "+A0.2", "+AM2", "+R9"};
    const auto with = [&](const char* more) {
        std::vector<std::string> all = words;
        all.emplace_back(more);
        return all;
    };
    const Clock::time_point begun = Clock::now();
    REQUIRE(support::run_program(folder.path(), WHITTLE_PROGRAM, with("+Owhole.png")).status == 0);
    const double whole_seconds = std::chrono::duration<double>(Clock::now() - begun).count();
    std::mt19937 random(17);
    int stopped_early = 0, with_picture = 0;
    for (int i = 0; i < 20; ++i) {
        INFO("signal " << i);
        RunningProgram program(folder.path(), WHITTLE_PROGRAM, words);
        std::this_thread::sleep_for(
            std::chrono::duration<double>(whole_seconds * std::uniform_real_distribution(0.05, 1.0)(random)));
        const int signal = i % 2 ? SIGTERM : SIGINT;
        const Stopped stopped = stop(program, signal);
        check_at_once(stopped);
        INFO("status " << stopped.ended.status << "\n" << stopped.ended.err);
        // On a busy machine a signal may come before the program itself has begun: the system ends it, and nothing was
        // done.
        const bool too_early = stopped.ended.status == -signal && stopped.ended.err.empty();
        REQUIRE((stopped.ended.status == 2 || stopped.ended.status == 0 || too_early));
        stopped_early += stopped.ended.status == 2;
        // Whole or not there; a signal may come between the last write and the end of the program.
        const bool complete = std::filesystem::exists(folder / "s.png");
        CHECK((complete || stopped.ended.status != 0));
        if (complete) CHECK(text_of(folder / "s.png") == text_of(folder / "whole.png"));
        const bool state = std::filesystem::exists(folder / "s.whittle-state");
        CHECK(std::filesystem::exists(folder / "s.partial.png") == state);
        if (state) {
            ++with_picture;
            check_part_of(folder / "s.partial.png", folder / "whole.png", 8 * 4);
        }
        const Ended continued = support::run_program(folder.path(), WHITTLE_PROGRAM, with("+C"));
        INFO(continued.err);
        CHECK(continued.status == 0);
        CHECK(text_of(folder / "s.png") == text_of(folder / "whole.png"));
        CHECK(folder.names() == std::vector<std::string>{"s.png", "s.pov", "whole.png"});
        std::filesystem::remove(folder / "s.png");
    }
    CHECK(stopped_early >= 5);
    CHECK(with_picture >= 2);
}

TEST_CASE("a signal ends what takes minutes", "[cancel]")
{
    const std::string lamp = "light_source { <-5, 5, -5>, 1 }\n";
    const std::string costly[] = {
        // One block: samples of samples of samples.
        lamp + "light_source { <5, 5, -5>, 1 area_light x*3, y*3, 17, 17 }\nplane { y, -1 pigment { granite } finish { "
               "reflection 0.3 } }\n"
               "sphere { 0, 1 pigment { rgbt 0.5 } finish { reflection 0.5 } interior { ior 1.5 } }\n",
        // One point of one pigment.
        lamp + "plane { y, -1 pigment { function { sum(i, 1, 1e10, sin(x*i)) } } }\n",
        // Text: a loop of tokens, one of rays, a height field.
        "#declare I = 0;\n#while (I >= 0) #declare I = I + 1; #end\n",
        "#declare Normal = y;\n#declare Ball = isosurface { function { x*x + y*y + z*z - 1 + f_noise3d(x*9, y*9, "
        "z*9)*0.3 } contained_by { box { -2, 2 } } max_gradient 8 }\n"
        "#declare I = 0;\n#while (I >= 0) #declare Met = trace(Ball, <sin(I), 5, cos(I)>, -y, Normal); #declare I = I "
        "+ 1; #end\n",
        "height_field { function 6000, 6000 { f_ridged_mf(x*5, y*5, 0, 0.5, 2, 9, 0.7, 0.7, 2) } }\n",
    };
    for (const std::string& scene : costly) {
        INFO(scene);
        const support::TemporaryFolder folder;
        write_text(folder / "s.pov", kHead + scene);
        RunningProgram program(folder.path(), WHITTLE_PROGRAM,
                               {"s.pov", "+W64", "+H48", "+BS64", "+A0.0", "+AM2", "+R9"});
        const Clock::time_point begun = Clock::now();
        while (program.cpu_seconds() < 0.2 && program.running() && Clock::now() - begun < std::chrono::seconds(20))
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const Stopped stopped = stop(program, SIGINT);
        check_at_once(stopped);
        CHECK(stopped.ended.status == 2);
        CHECK_THAT(stopped.ended.err, Catch::Contains("cancelled"));
        CHECK(folder.names() == std::vector<std::string>{"s.pov"});
    }
}
