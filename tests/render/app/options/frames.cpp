#include "render/app/frames/frames.h"

#include "render/app/options/command_line.h"

#include <catch2/catch.hpp>

using namespace app;

namespace {

FrameList list_of(const std::vector<std::string>& arguments)
{
    Settings settings;
    apply_command_line(settings, arguments);
    return frames_of(settings);
}

std::vector<int> frame_numbers(const FrameList& list)
{
    std::vector<int> found;
    for (const Frame& frame : list.frames) found.push_back(frame.number);
    return found;
}

std::vector<float> clocks(const FrameList& list)
{
    std::vector<float> found;
    for (const Frame& frame : list.frames) found.push_back(frame.clock);
    return found;
}

}  // namespace

TEST_CASE("a still picture", "[app][frames]")
{
    CHECK_FALSE(list_of({}).animation);
    CHECK_FALSE(list_of({}).clock_on);
    CHECK_FALSE(list_of({"+KFI1", "+KFF1"}).animation);
    const FrameList still = list_of({"+K0.1"});
    CHECK(still.clock_on);
    CHECK(clocks(still) == std::vector<float>{0.1f});
}

TEST_CASE("frames and clocks as POV-Ray's", "[app][frames]")
{
    CHECK(clocks(list_of({"+KFF3"})) == std::vector<float>{0.0f, 0.5f, 1.0f});
    const FrameList cyclic = list_of({"+KFF3", "+KC"});
    CHECK(clocks(cyclic) == std::vector<float>{0.0f, 0.333333343f, 0.666666687f});
    CHECK(cyclic.final_frame == 4);
    CHECK(cyclic.last_frame == 3);
    const FrameList part = list_of({"+KFI2", "+KFF4", "+KI10", "+KF20"});
    CHECK(frame_numbers(part) == std::vector<int>{2, 3, 4});
    CHECK(clocks(part) == std::vector<float>{10.0f, 15.0f, 20.0f});
}

TEST_CASE("subsets and steps", "[app][frames]")
{
    CHECK(frame_numbers(list_of({"+KFF10", "+SF3", "+EF5"})) == std::vector<int>{3, 4, 5});
    CHECK(frame_numbers(list_of({"+KFF10", "+SF0.3", "+EF0.5"})) == std::vector<int>{3, 4, 5});
    CHECK(list_of({"+KFF10", "+SF3", "+EF5"}).frames[0].clock == 0.222222224f);
    CHECK(frame_numbers(list_of({"+KFF10", "+STP3"})) == std::vector<int>{1, 4, 7, 10});
    CHECK(clocks(list_of({"+KFI5"})) == std::vector<float>{0.0f});
}

TEST_CASE("frames without end are refused", "[app][frames]")
{
    CHECK_THROWS_WITH(list_of({"+KFF2000000000"}), "frames have numbers up to 1000000000");
    CHECK_THROWS_WITH(list_of({"+KFF1000000000"}), "an animation has at most 10000000 frames, these are 1000000000");
    CHECK(frame_numbers(list_of({"+KFF1000000000", "+STP2000000000"})) == std::vector<int>{1});
    CHECK(frame_numbers(list_of({"+KFF1000000000", "+SF999999999", "+EF1e300"})) ==
          std::vector<int>{999999999, 1000000000});
}

TEST_CASE("a list names frames of the animation", "[app][frames]")
{
    CHECK(frame_numbers(list_of({"+KFF30", "--frames=2,4,10-20:5"})) == std::vector<int>{2, 4, 10, 15, 20});
    CHECK(frame_numbers(list_of({"+KFF30", "--frames=9,7-9,8"})) == std::vector<int>{7, 8, 9});
    CHECK(frame_numbers(list_of({"+KFF30", "+SF3", "+EF5", "--frames=29"})) ==
          std::vector<int>{29});  // instead of a subset
    CHECK(list_of({"+KFF10", "--frames=3"}).frames[0].clock == list_of({"+KFF10", "+SF3", "+EF3"}).frames[0].clock);
    CHECK(list_of({"+KFF100", "--frames=3"}).digits == 3);
    CHECK_THROWS_WITH(list_of({"--frames=3"}), Catch::StartsWith("--frames is for an animation"));
    CHECK_THROWS_WITH(list_of({"+KFF10", "--frames=3-11"}),
                      "--frames: 11 is not a frame of the animation, which has 1 to 10");
    for (const char* wrong : {"--frames=", "--frames=3-", "--frames=-3", "--frames=3,", "--frames=5-3",
                              "--frames=1-9:0", "--frames=2;4", "--frames=99999999999"}) {
        INFO(wrong);
        CHECK_THROWS(list_of({"+KFF10", wrong}));
    }
}
