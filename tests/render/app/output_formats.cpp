// Picture files as bytes. The samples are those of POV-Ray 3.7.0.10 for the scene below, as in
//     povray s.pov +FP5 +THB2 +W8 +H6 -D
#include "render/image/files.h"

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

namespace {

using support::run_program;
using support::text_of;
using Words = std::vector<std::string>;

constexpr const char* kRampScene = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { orthographic location "
                                   "<0, 0, -1> look_at 0 right x*8 up y*6 }\n"
                                   "plane { z, 0 pigment { gradient x color_map { [0 rgb <0.05, 0.3, 1.1>] [1 rgb "
                                   "<0.9, 0.1, 0.4>] } scale 9 translate -x*4.7 }\n"
                                   "  finish { emission 1 ambient 0 diffuse 0 } }\n";

std::string hex(std::string_view bytes)
{
    constexpr const char* kDigits = "0123456789abcdef";
    std::string out;
    for (const char c : bytes) {
        out += kDigits[static_cast<unsigned char>(c) >> 4];
        out += kDigits[static_cast<unsigned char>(c) & 15];
    }
    return out;
}

/// The bytes that the program writes to standard output.
std::string written(const Words& options)
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "s.pov", kRampScene);
    Words words{"s.pov", "+O-"};
    words.insert(words.end(), options.begin(), options.end());
    const support::Ended ended = run_program(folder.path(), WHITTLE_PROGRAM, words);
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    return ended.out;
}

std::string last_bytes(const std::string& bytes, std::size_t count)
{
    return hex(std::string_view(bytes).substr(bytes.size() - count));
}

}  // namespace

TEST_CASE("dithering rounds as POV-Ray does, by all six methods", "[program][output]")
{
    struct Row {
        const char *method, *samples;
    };
    const Row rows[] = {
        {"B2", "0d111f11111f13101d16101c170e1a1a0e1a1b0c171d0c170e121f11111e14101d160f1c180f1b190e191b0d181c0c160d111f1"
               "1111f13101d16101c170e1a1a0e1a1b0c171d0c170e121f11111e14101d160f1c180f1b190e191b0d181c0c160d111f11111f13"
               "101d16101c170e1a1a0e1a1b0c171d0c170e121f11111e14101d160f1c180f1b190e191b0d181c0c16"},
        {"B3", "0e111f11111e13101d160f1c180f1b190d191b0d171d0c160e121f10101e14101d16101c170e1a1a0e191b0d181c0b160e111f1"
               "1111f14101d160f1c180f1b190e191b0d181d0c170e111f11111e13101d160f1c180f1b190d191b0d171d0c160e121f10101e14"
               "101d16101c170e1a1a0e191b0d181c0b160e111f11111f14101d160f1c180f1b190e191b0d181d0c17"},
        {"B4", "0d111f11111e13101d16101c170e1a1a0e191b0c171d0c170e111f11101e14101d160f1c180f1a190d191b0d181c0c160d111f1"
               "1111e13101d16101c170e1a1a0e191b0c171d0c160e121f11111e14101d160f1c180f1b190e191b0d181c0c160d111f11111e13"
               "101d16101c170e1a1a0e191b0c171d0c170e111f11101e14101d160f1c180f1a190d191b0d181c0c16"},
        {"D1", "0e111f11111e13101d160f1c170f1a1a0d191b0d181c0c160e111f11111e14101d150f1b180f1b190d191b0d171d0c160d111f1"
               "1111e13101d160f1c170e1a1a0e191b0d181c0b160e121f11101e14101d15101b180e1b190e191b0c171d0c160d111f11111e13"
               "101d160f1c170f1a1a0d191b0d181c0c160e111f11111e14101d150f1b180f1b190d191b0d171d0b16"},
        {"D2", "0e111f11111e13101d160f1c180f1a190d191b0d181c0c160e111f11111e13101d160f1b170f1b190d191b0d181d0c160e111f1"
               "1111e13101d160f1c180f1a190d191b0d171d0c160e111f11111e13101d160f1b170f1b1a0d191b0d181c0c160e111f11111e13"
               "101d160f1c180f1a190d191b0d181d0c160e111f11111e13101d160f1b170f1b190d191b0d171c0c16"},
        {"FS", "0e111f11111e13101d160f1c180f1a190d191b0d181c0c160e111f11111e13101d160f1b170e1b1a0e191b0d171d0b160e111f1"
               "1111e13101d160f1c180f1a190d191b0d181c0c160e111f11111e13101d160f1b170f1b190e191b0c181d0c160d111f11111e14"
               "101d150f1c180e1a1a0e191b0d171c0b160d111f11111e13101d160f1b180f1b190d191b0d181d0c16"},
    };
    for (const Row& row : rows) {
        INFO(row.method);
        CHECK(last_bytes(written({"+FP5", std::string("+TH") + row.method, "+W8", "+H6"}), 144) == row.samples);
        CHECK(last_bytes(written({"+FP5", "Dither=on", std::string("Dither_Method=") + row.method, "+W8", "+H6"}),
                         144) == row.samples);
    }
    CHECK(written({"+FP5", "+TH", "+W8", "+H6"}) == written({"+FP5", "+THFS", "+W8", "+H6"}));
    CHECK(written({"+FP5", "+THB2", "-TH", "+W8", "+H6"}) == written({"+FP5", "+W8", "+H6"}));
}

TEST_CASE("PPM has one or two bytes a sample; PGM has two, without gamma", "[program][output]")
{
    const std::string twelve = written({"+FP12", "+W4", "+H3"}), grey = written({"+FPg", "+W4", "+H3"});
    CHECK(twelve.starts_with("P6\n# Software: Whittle\n4 3\n4095\n"));
    CHECK(last_bytes(twelve, 72) == "07f008c80fc40aa208100e980ca607400d490e50064f0bc607f008c80fc40aa208100e980ca607400d"
                                    "490e50064f0bc607f008c80fc40aa208100e980ca607400d490e50064f0bc6");
    CHECK(grey.starts_with("P5\n# Software: Whittle\n4 3\n65535\n"));
    CHECK(last_bytes(grey, 24) == "53ca56e95a085d2753ca56e95a085d2753ca56e95a085d27");
}

TEST_CASE("each output type makes a file of its kind and size", "[program][output]")
{
    struct Row {
        const char *type, *file;
        int channels, bits;
    };
    for (const Row& row : {Row{"+FN", "s.png", 4, 8}, Row{"+FN16", "s.png", 4, 16}, Row{"+FNg", "s.png", 2, 16},
                           Row{"+FP", "s.ppm", 3, 8}, Row{"+FP16", "s.ppm", 3, 16}, Row{"+FT", "s.tga", 4, 8},
                           Row{"+FC", "s.tga", 4, 8}, Row{"+FJ", "s.jpg", 3, 8}, Row{"+FB", "s.bmp", 4, 8},
                           Row{"+FE", "s.exr", 4, 0}, Row{"+FH", "s.hdr", 3, 32}}) {
        INFO(row.type);
        const support::TemporaryFolder folder;
        support::write_text(folder / "s.pov", kRampScene);
        REQUIRE(run_program(folder.path(), WHITTLE_PROGRAM, {"s.pov", row.type, "+UA", "+W16", "+H12"}).status == 0);
        const image::Picture picture = image::Files().read(folder / row.file);
        CHECK(picture.width == 16);
        CHECK(picture.height == 12);
        CHECK(picture.channels == row.channels);
        if (row.bits > 0) CHECK(picture.bits == row.bits);
        const std::string type = row.type;
        if (type != "+FN" && type != "+FP" && type != "+FB") continue;  // a writer of ours each, and the library's
        support::write_text(
            folder / "piped",
            run_program(folder.path(), WHITTLE_PROGRAM, {"s.pov", row.type, "+UA", "+W16", "+H12", "+O-"}).out);
        CHECK(text_of(folder / "piped") == text_of(folder / row.file));
    }
}
