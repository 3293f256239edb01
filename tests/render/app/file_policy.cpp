// What a scene may read and write. By default it writes below the current folder and the picture's, and reads anything.
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>

namespace {

using support::Ended;
using support::run_program;
using support::write_text;
using Words = std::vector<std::string>;

std::string writes(const std::string& path)
{
    return "#fopen F \"" + path + "\" write\n#write(F, \"text\")\n#fclose F\ncamera { location -z }\n";
}

int status(const support::TemporaryFolder& folder, Words words)
{
    words.insert(words.end(), {"+W4", "+H3"});
    return run_program(folder / "here", WHITTLE_PROGRAM, words).status;
}

/// Folders `here`, where the program runs, and `there`, beside it.
void make(const support::TemporaryFolder& folder, const std::string& scene)
{
    for (const char* name : {"here", "here/out", "there"}) std::filesystem::create_directories(folder / name);
    write_text(folder / "here/s.pov", scene);
}

}  // namespace

TEST_CASE("a scene writes below the current folder and the picture's, elsewhere only with --allow-write",
          "[program][policy]")
{
    const support::TemporaryFolder folder;
    make(folder, writes("out/x.txt"));
    CHECK(status(folder, {"s.pov"}) == 0);
    CHECK(support::text_of(folder / "here/out/x.txt") == "text");
    make(folder, writes(folder / "there/x.txt"));
    CHECK(status(folder, {"s.pov"}) == 1);
    CHECK_FALSE(std::filesystem::exists(folder / "there/x.txt"));
    CHECK(status(folder, {"s.pov", "--allow-write=" + (folder / "there")}) == 0);
    std::filesystem::remove(folder / "there/x.txt");
    CHECK(status(folder, {"s.pov", "+O" + (folder / "there/s.png")}) == 0);
    CHECK(std::filesystem::exists(folder / "there/x.txt"));
    // Neither dots nor a link lead out.
    make(folder, writes("../there/y.txt"));
    CHECK(status(folder, {"s.pov"}) == 1);
    std::filesystem::create_directory_symlink(folder / "there", folder / "here/link");
    make(folder, writes("link/y.txt"));
    CHECK(status(folder, {"s.pov"}) == 1);
    CHECK_FALSE(std::filesystem::exists(folder / "there/y.txt"));
}

TEST_CASE("--check makes none of the files that a scene writes", "[program][policy]")
{
    const support::TemporaryFolder folder;
    make(folder, writes("out/x.txt"));
    CHECK(status(folder, {"s.pov", "--check"}) == 0);
    CHECK(std::filesystem::is_empty(folder / "here/out"));
}

TEST_CASE("--check reads again what a scene would have written", "[program][policy]")
{
    const support::TemporaryFolder folder;
    const std::string file = "\"" + (folder / "here/out/part.inc") + "\"";
    const std::string scene = "#fopen F " + file + " write\n#write(F, \"#declare A = 1;\\n\")\n#fclose F\n#include " +
                              file +
                              "\n"
                              "#fopen F " +
                              file + " append\n#write(F, \"#declare B = 2;\\n\")\n#fclose F\n#include " + file +
                              "\n"
                              "#if (A + B != 3) #error \"lost\" #end\n";
    make(folder, scene + "camera { location -z }\n");
    CHECK(status(folder, {"s.pov", "--check"}) == 0);
    CHECK(std::filesystem::is_empty(folder / "here/out"));
    CHECK(status(folder, {"s.pov"}) == 0);
    make(folder, "#fopen F " + file + " write\n#write(F, \"#declare C = 1;\\n\")\n#fclose F\n#include " + file +
                     "\n#declare A = B;\n");
    CHECK(status(folder, {"s.pov", "--check"}) == 1);
    CHECK(status(folder, {"s.pov"}) == 1);
}

TEST_CASE("--restrict-read keeps a scene to the folders that it is given", "[program][policy]")
{
    const support::TemporaryFolder folder;
    const std::string end = "camera { location -z }\n";
    make(folder, "#include \"" + (folder / "there/a.inc") + "\"\n" + end);
    write_text(folder / "there/a.inc", "#declare A = 1;\n");
    CHECK(status(folder, {"s.pov"}) == 0);
    CHECK(status(folder, {"s.pov", "--restrict-read"}) == 1);
    CHECK(status(folder, {"s.pov", "--restrict-read", "+L" + (folder / "there")}) == 0);
    make(folder, "#fopen F \"" + (folder / "there/a.inc") + "\" read\n" + end);
    CHECK(status(folder, {"s.pov"}) == 0);
    CHECK(status(folder, {"s.pov", "--restrict-read"}) == 1);
    make(folder, "#if (file_exists(\"" + (folder / "there/a.inc") + "\")) #error \"seen\" #end\n" + end);
    CHECK(status(folder, {"s.pov"}) == 1);
    CHECK(status(folder, {"s.pov", "--restrict-read"}) == 0);
    make(folder, "#include \"colors.inc\"\n" + end);
    CHECK(status(folder, {"s.pov", "--restrict-read"}) == 0);  // the library
}

TEST_CASE("files that #fopen and images read are among the files of a picture", "[program][policy]")
{
    const support::TemporaryFolder folder;
    make(folder, "#fopen F \"data.txt\" read\n#read(F, A)\ncamera { location -z }\n");
    write_text(folder / "here/data.txt", "1, 2\n");
    CHECK(run_program(folder / "here", WHITTLE_PROGRAM, {"s.pov", "--deps"}).out.ends_with("s.pov\ndata.txt\n"));
    write_text(folder / "here/picture.ppm", "P6 1 1 255 abc");
    make(folder, "camera { location -z }\nsphere { 0, 1 pigment { image_map { ppm \"picture.ppm\" } } }\n");
    CHECK(run_program(folder / "here", WHITTLE_PROGRAM, {"s.pov", "--deps"}).out.ends_with("s.pov\npicture.ppm\n"));
}
