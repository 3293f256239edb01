// Animations as POV-Ray 3.7.0.10 runs them. Each animation is what it printed and which files it made for
//     povray a.pov OPTIONS +W4 +H3 -D
// with the scene below. (Where its clock is no number, for one frame, Whittle has the initial clock:
// options/frames.cpp.)
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <sstream>

namespace {

using Words = std::vector<std::string>;

constexpr const char* kFrameScene = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
                                    "#debug concat(\"f \", str(frame_number,0,0), \" \", str(initial_frame,0,0), \" "
                                    "\", str(final_frame,0,0), \" c \", str(clock,0,6),"
                                    " \" ic \", str(initial_clock,0,4), \" fc \", str(final_clock,0,4), \" cd \", "
                                    "str(clock_delta,0,6), \" on \", str(clock_on,0,0), \"\\n\")\n"
                                    "camera { location -z }\n";

struct Animation {
    const char* options;
    std::string printed;
    Words files;
};

const std::vector<Animation>& animations()
{
    static const std::vector<Animation> all = {
        {"+KFF3",
         "f 1 1 3 c 0.000000 ic 0.0000 fc 1.0000 cd 0.500000 on 1\n"
         "f 2 1 3 c 0.500000 ic 0.0000 fc 1.0000 cd 0.500000 on 1\n"
         "f 3 1 3 c 1.000000 ic 0.0000 fc 1.0000 cd 0.500000 on 1\n",
         {"a1.png", "a2.png", "a3.png"}},
        {"+KFI2 +KFF4 +KI10 +KF20",
         "f 2 2 4 c 10.000000 ic 10.0000 fc 20.0000 cd 5.000000 on 1\n"
         "f 3 2 4 c 15.000000 ic 10.0000 fc 20.0000 cd 5.000000 on 1\n"
         "f 4 2 4 c 20.000000 ic 10.0000 fc 20.0000 cd 5.000000 on 1\n",
         {"a2.png", "a3.png", "a4.png"}},
        {"+KFF3 +KC",
         "f 1 1 4 c 0.000000 ic 0.0000 fc 1.0000 cd 0.333333 on 1\n"
         "f 2 1 4 c 0.333333 ic 0.0000 fc 1.0000 cd 0.333333 on 1\n"
         "f 3 1 4 c 0.666667 ic 0.0000 fc 1.0000 cd 0.333333 on 1\n",
         {"a1.png", "a2.png", "a3.png"}},
        {"+KFF10 +SF3 +EF5",
         "f 3 1 10 c 0.222222 ic 0.0000 fc 1.0000 cd 0.111111 on 1\n"
         "f 4 1 10 c 0.333333 ic 0.0000 fc 1.0000 cd 0.111111 on 1\n"
         "f 5 1 10 c 0.444444 ic 0.0000 fc 1.0000 cd 0.111111 on 1\n",
         {"a03.png", "a04.png", "a05.png"}},
        {"+KFF10 +SF0.3 +EF0.5",
         "f 3 1 10 c 0.222222 ic 0.0000 fc 1.0000 cd 0.111111 on 1\n"
         "f 4 1 10 c 0.333333 ic 0.0000 fc 1.0000 cd 0.111111 on 1\n"
         "f 5 1 10 c 0.444444 ic 0.0000 fc 1.0000 cd 0.111111 on 1\n",
         {"a03.png", "a04.png", "a05.png"}},
        {"+KFF10 +STP3",
         "f 1 1 10 c 0.000000 ic 0.0000 fc 1.0000 cd 0.111111 on 1\n"
         "f 4 1 10 c 0.333333 ic 0.0000 fc 1.0000 cd 0.111111 on 1\n"
         "f 7 1 10 c 0.666667 ic 0.0000 fc 1.0000 cd 0.111111 on 1\n"
         "f 10 1 10 c 1.000000 ic 0.0000 fc 1.0000 cd 0.111111 on 1\n",
         {"a01.png", "a04.png", "a07.png", "a10.png"}},
        {"+K0.5", "f 0 0 0 c 0.500000 ic 0.0000 fc 0.0000 cd 0.000000 on 1\n", {"a.png"}},
        {"+KFI0 +KFF2 +K7",
         "f 0 0 2 c 0.000000 ic 0.0000 fc 1.0000 cd 0.500000 on 1\n"
         "f 1 0 2 c 0.500000 ic 0.0000 fc 1.0000 cd 0.500000 on 1\n"
         "f 2 0 2 c 1.000000 ic 0.0000 fc 1.0000 cd 0.500000 on 1\n",
         {"a0.png", "a1.png", "a2.png"}},
        {"+KFF12 +SF11 +EF14",
         "f 11 1 12 c 0.909091 ic 0.0000 fc 1.0000 cd 0.090909 on 1\n"
         "f 12 1 12 c 1.000000 ic 0.0000 fc 1.0000 cd 0.090909 on 1\n"
         "f 13 1 12 c 1.090909 ic 0.0000 fc 1.0000 cd 0.090909 on 1\n"
         "f 14 1 12 c 1.181818 ic 0.0000 fc 1.0000 cd 0.090909 on 1\n",
         {"a11.png", "a12.png", "a13.png", "a14.png"}},
        {"+KFI-2 +KFF1",
         "f 0 0 1 c 0.000000 ic 0.0000 fc 1.0000 cd 1.000000 on 1\n"
         "f 1 0 1 c 1.000000 ic 0.0000 fc 1.0000 cd 1.000000 on 1\n",
         {"a0.png", "a1.png"}},
        {"+KI2 +KF3", "f 0 0 0 c 0.000000 ic 0.0000 fc 0.0000 cd 0.000000 on 0\n", {"a.png"}},
        {"+KFI1 +KFF1", "f 0 0 0 c 0.000000 ic 0.0000 fc 0.0000 cd 0.000000 on 0\n", {"a.png"}},
        {"+KFI0 +KFF0", "f 0 0 0 c 0.000000 ic 0.0000 fc 0.0000 cd 0.000000 on 0\n", {"a.png"}},
        {"+KFF3 +KI1 +KF0",
         "f 1 1 3 c 1.000000 ic 1.0000 fc 0.0000 cd -0.500000 on 1\n"
         "f 2 1 3 c 0.500000 ic 1.0000 fc 0.0000 cd -0.500000 on 1\n"
         "f 3 1 3 c 0.000000 ic 1.0000 fc 0.0000 cd -0.500000 on 1\n",
         {"a1.png", "a2.png", "a3.png"}},
        {"+KFF4 +EF2",
         "f 1 1 4 c 0.000000 ic 0.0000 fc 1.0000 cd 0.333333 on 1\n"
         "f 2 1 4 c 0.333333 ic 0.0000 fc 1.0000 cd 0.333333 on 1\n",
         {"a1.png", "a2.png"}},
        {"+KFF3 +SF5", "f 5 1 3 c 2.000000 ic 0.0000 fc 1.0000 cd 0.500000 on 1\n", {"a5.png"}},
        {"+KFF2 +KC +EF3",
         "f 1 1 3 c 0.000000 ic 0.0000 fc 1.0000 cd 0.500000 on 1\n"
         "f 2 1 3 c 0.500000 ic 0.0000 fc 1.0000 cd 0.500000 on 1\n"
         "f 3 1 3 c 1.000000 ic 0.0000 fc 1.0000 cd 0.500000 on 1\n",
         {"a1.png", "a2.png", "a3.png"}},
        {"+KFF2 +KC +SF3", "f 3 1 3 c 1.000000 ic 0.0000 fc 1.0000 cd 0.500000 on 1\n", {"a3.png"}},
    };
    return all;
}

/// The lines of the scene's #debug.
std::string debug_lines(const std::string& text)
{
    std::istringstream lines(text);
    std::string found;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("f ")) found += line + "\n";
    return found;
}

}  // namespace

TEST_CASE("frames, clocks and names of animations are POV-Ray's", "[program][animation]")
{
    for (const Animation& animation : animations()) {
        INFO(animation.options);
        const support::TemporaryFolder folder;
        support::write_text(folder / "a.pov", kFrameScene);
        const support::Ended ended =
            support::run_program(folder.path(), WHITTLE_PROGRAM, {"a.pov", animation.options, "+W4 +H3 -D"});
        CHECK(ended.status == 0);
        CHECK(debug_lines(ended.err) == animation.printed);
        Words names = folder.names();
        names.erase(std::remove(names.begin(), names.end(), "a.pov"), names.end());
        CHECK(names == animation.files);
    }
}

TEST_CASE("a frame that fails ends an animation; the frames before it stay", "[program][animation]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "a.pov", "camera { location -z }\n#if (frame_number = 3) #error \"three\" #end\n");
    const support::Ended ended = support::run_program(folder.path(), WHITTLE_PROGRAM, {"a.pov", "+KFF4", "+W4", "+H3"});
    CHECK(ended.status == 1);
    CHECK(folder.names() == Words{"a.pov", "a1.png", "a2.png"});
}
