#include "render/app/options/command_line.h"
#include "render/app/options/option_table.h"

#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <fstream>

using namespace app;

namespace {

Settings settings_of(const std::vector<std::string>& arguments)
{
    Settings settings;
    apply_command_line(settings, arguments);
    return settings;
}

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("an argument is split at blanks outside quotes", "[app][options]")
{
    CHECK(words_of("+W16 +H9") == Words{"+W16", "+H9"});
    CHECK(words_of("  -D  ") == Words{"-D"});
    CHECK(words_of("+I'tea pot.pov'") == Words{"+Itea pot.pov"});
    CHECK(words_of("\"Input_File_Name='tea pot.pov'\"") == Words{"Input_File_Name='tea pot.pov'"});
    CHECK(words_of("+W\"16\"") == Words{"+W16"});
    CHECK(words_of("Declare='bar=\"hello\"'") == Words{"Declare=bar=\"hello\""});
    CHECK(words_of("''") == Words{""});
    CHECK(words_of("").empty());
}

TEST_CASE("the switches of the quick-start line", "[app][options]")
{
    const Settings s = settings_of({"+Iscene.pov", "+Oout.png", "+W640", "+H480", "+A0.25", "-D", "-P", "+Lone",
                                    "+Ltwo/", "+Q8", "+FN16", "+WT2", "Declare=x=1.5"});
    CHECK(s.input_file == "scene.pov");
    CHECK(s.output_file == "out.png");
    CHECK(s.width == 640);
    CHECK(s.height == 480);
    CHECK(s.antialias);
    CHECK(s.antialias_threshold == 0.25f);
    CHECK(s.library_path == Words{"one", "two"});
    CHECK(s.quality == 8);
    CHECK(s.file_type == image::FileType::Png);
    CHECK(s.bits_per_color == 16);
    CHECK(s.threads == 2);
    CHECK(s.declared_numbers.at("x") == 1.5);
    CHECK(s.not_acted_on.empty());
}

TEST_CASE("the sign of a switch counts for truths only", "[app][options]")
{
    CHECK(settings_of({"-W8"}).width == 8);
    const Settings off = settings_of({"-A0.1"});
    CHECK_FALSE(off.antialias);
    CHECK(off.antialias_threshold == 0.1f);
    const Settings no_file = settings_of({"-FT"});
    CHECK_FALSE(no_file.output_to_file);
    CHECK(no_file.file_type == image::FileType::Targa);
    CHECK_FALSE(settings_of({"-J0.5"}).jitter);
    CHECK(settings_of({"+ua"}).alpha);
}

TEST_CASE("later settings override earlier ones and numbers are read by prefix", "[app][options]")
{
    CHECK(settings_of({"+W9", "Width=12"}).width == 12);
    CHECK(settings_of({"Width=12 +W9x"}).width == 9);
    CHECK(settings_of({"+Q99"}).quality == 11);
    CHECK(settings_of({"+R0"}).antialias_depth == 1);
    CHECK(settings_of({"Antialias_Threshold=3"}).antialias_threshold == 1.0f);
}

TEST_CASE("switches that share letters are told apart by the order of the table", "[app][options]")
{
    CHECK(settings_of({"+AM2"}).sampling_method == 2);
    CHECK(settings_of({"+AG1.5"}).antialias_gamma == 1.5f);
    CHECK(settings_of({"+A"}).antialias);
    CHECK(settings_of({"+KFF7"}).final_frame == 7);
    CHECK(settings_of({"+KF7"}).final_clock == 7.0f);
    CHECK(settings_of({"+KFI2"}).initial_frame == 2);
    CHECK(settings_of({"+KI2"}).initial_clock == 2.0f);
    CHECK(settings_of({"+K0.5"}).clock == 0.5f);
    CHECK(settings_of({"+KC"}).cyclic);
    CHECK(settings_of({"+SF0.5"}).subset_start_frame == 0.5);
    CHECK(settings_of({"+SF3"}).subset_start_frame == 3.0);
    CHECK(settings_of({"+SC2"}).start_column == 2.0);
    CHECK(settings_of({"+STP3"}).frame_step == 3);
    CHECK(settings_of({"+MV3.5"}).version == 350);
    CHECK(settings_of({"+R4"}).antialias_depth == 4);
    CHECK(settings_of({"+FPg"}).greyscale);
}

TEST_CASE("POV-Ray's truths", "[app][options]")
{
    for (const char* text : {"on", "ON", "true", "yes", "1", "o", "onward", ""}) CHECK(truth_of(text));
    for (const char* text : {"off", "0", "maybe", "false", "no"}) CHECK_FALSE(truth_of(text));
}

TEST_CASE("a flag is set by what says yes or no, and by nothing else", "[app][options]")
{
    for (const char* text : {"on", "o", "onward", "1", "Yes", ""})
        CHECK(settings_of({"-A", std::string("Antialias=") + text}).antialias);
    for (const char* text : {"off", "of", "0", "No", "false", "f"})
        CHECK_FALSE(settings_of({"+A", std::string("Antialias=") + text}).antialias);
    CHECK_THROWS_WITH(settings_of({"Antialias=maybe"}), "Antialias wants on or off, found 'maybe'");
    CHECK_THROWS_WITH(settings_of({"Display=2"}), "Display wants on or off, found '2'");
}

TEST_CASE("a declared number has single precision and six digits", "[app][options]")
{
    const Settings s = settings_of(
        {"Declare=a=3.14159265", "Declare=b=1234567", "Declare=c=1e10", "Declare=a=2", "Declare='d=\"hello\"'"});
    CHECK(s.declared_numbers.at("a") == 3.14159);
    CHECK(s.declared_numbers.at("b") == 1234570.0);
    CHECK(s.declared_numbers.at("c") == 1e10);
    CHECK(s.declared_strings.at("d") == "hello");
}

TEST_CASE("what cannot be understood is an error that names it", "[app][options]")
{
    CHECK_THROWS_WITH(settings_of({"+W"}), "unknown switch '+W'");
    CHECK_THROWS_WITH(settings_of({"+Wabc"}), "Width wants a number, found 'abc'");
    CHECK_THROWS_WITH(settings_of({"+ZZ"}), "unknown switch '+ZZ'");
    CHECK_THROWS_WITH(settings_of({"Widht=3"}), "unknown option 'Widht'; did you mean 'Width'?");
    CHECK_THROWS_WITH(settings_of({"antialais=on"}), "unknown option 'antialais'; did you mean 'Antialias'?");
    CHECK_THROWS_WITH(settings_of({"Nonsense=3"}), "unknown option 'Nonsense'");
    CHECK_THROWS_WITH(settings_of({"--jsno", "x"}), "unknown option '--jsno'; did you mean '--json'?");
    CHECK_THROWS_WITH(settings_of({"--Preveiw=x"}), "unknown option '--Preveiw=x'; did you mean '--preview'?");
    CHECK_THROWS_WITH(settings_of({"--nonsense"}), "unknown option '--nonsense'");
    CHECK_THROWS_WITH(settings_of({"+A5"}), "unknown switch '+A5': the threshold of +A lies from 0 to 1, as in +A0.3");
    CHECK_THROWS_WITH(settings_of({"-A1.5"}), Catch::StartsWith("unknown switch '-A1.5'"));
    CHECK_THROWS_WITH(settings_of({"+FN8g"}), "unknown output file type 'N8g'");
    CHECK_THROWS_WITH(settings_of({"+FX"}), "unknown output file type 'X'");
    CHECK_THROWS_WITH(settings_of({"Buffer_Size=3"}), "Buffer_Size is obsolete");
    CHECK_THROWS_WITH(settings_of({"File_Gamma=-1"}),
                      "File_Gamma wants a number above 0 or sRGB, BT709 or BT2020, found '-1'");
    CHECK_THROWS_WITH(settings_of({"--isa=v9"}), "--isa wants v2|v3|v4|auto, found 'v9'");
    CHECK_THROWS_AS(settings_of({"no-such-ini-file"}), OptionError);
}

TEST_CASE("an option without effect is noted once, and only when it asks for something", "[app][options]")
{
    CHECK(settings_of({"Real_Time_Raytracing=on", "Real_Time_Raytracing=on"}).not_acted_on ==
          Words{"Real_Time_Raytracing"});
    CHECK(settings_of({"-TH", "-RFO", "+D", "-D", "+P", "+UV", "+MB3", "-MB", "+X", "+SP8"}).not_acted_on.empty());
}

TEST_CASE("file gamma", "[app][options]")
{
    CHECK(settings_of({"File_Gamma=sRGB"}).file_gamma == image::TransferCurve::srgb());
    CHECK(settings_of({"File_Gamma=1.0"}).file_gamma == image::TransferCurve::linear());
    CHECK(settings_of({"File_Gamma=2.2"}).file_gamma == image::TransferCurve::power(2.2f));
}

TEST_CASE("a scene file whose name has blanks or looks like a switch is a scene", "[app][options]")
{
    const support::TemporaryFolder folder;
    const std::string name = folder / "tea pot.pov";
    std::ofstream(name) << "sphere { 0, 1 }";
    CHECK(settings_of({name}).input_file == name);
    const std::string plain = folder / "plain.pov";
    std::ofstream(plain) << "sphere { 0, 1 }";
    CHECK(settings_of({folder / "plain"}).input_file == plain);
}

TEST_CASE("every keyword of POV-Ray is known, in alphabetical order", "[app][options]")
{
    const auto table = option_table();
    CHECK(table.size() == 111 + 4 + 2);  // four of 3.8; Motion_Samples and Shutter are Whittle's own
    for (std::size_t i = 0; i < table.size(); ++i) {
        INFO(table[i].keyword);
        CHECK(find_option(table[i].keyword) == &table[i]);
        CHECK((table[i].apply != nullptr) == (table[i].state == State::Acts));
        const auto lower = [](unsigned char a, unsigned char b) { return std::tolower(a) < std::tolower(b); };
        if (i > 0)
            CHECK(std::lexicographical_compare(table[i - 1].keyword.begin(), table[i - 1].keyword.end(),
                                               table[i].keyword.begin(), table[i].keyword.end(), lower));
    }
}

TEST_CASE("a type of file that is more than its letter says what is written", "[app][options]")
{
    const auto notes = [](const char* word) { return settings_of({word}).notes; };
    for (const char* usual : {"Output_File_Type=N", "Output_File_Type=N8", "Output_File_Type=ppm",
                              "Output_File_Type=JPEG", "Output_File_Type=targa", "Output_File_Type=exr"})
        CHECK(notes(usual).empty());
    CHECK(settings_of({"Output_File_Type=PNG"}).file_type == image::FileType::Ppm);  // POV-Ray's rule
    REQUIRE(notes("Output_File_Type=PNG").size() == 1);
    CHECK_THAT(notes("Output_File_Type=PNG")[0], Catch::Contains("writes ppm: only the first letter counts, N PNG"));
    REQUIRE(notes("Output_File_Type=TIFF").size() == 1);
    CHECK_THAT(notes("Output_File_Type=TIFF")[0], Catch::Contains("writes tga"));
}

TEST_CASE("of two scenes on a command line the first is told to be dropped", "[app][options]")
{
    const support::TemporaryFolder folder;
    std::ofstream(folder / "of.ini") << "Input_File_Name=c.pov\n";
    const Settings two = settings_of({"a.pov", "+W8", "b.pov"});
    CHECK(two.input_file == "b.pov");
    CHECK(two.notes == Words{"'a.pov' is not rendered: 'b.pov' follows it, and a run renders one scene"});
    CHECK(settings_of({"a.pov b.pov"}).notes.size() == 1);
    CHECK(settings_of({"+Ia.pov", "+Ib.pov", "+Ic.pov"}).notes.size() == 2);
    CHECK(settings_of({"a.pov", folder / "of.ini"}).notes.size() == 1);
    CHECK(settings_of({"a.pov", "a.pov"}).notes.empty());
    const Settings over = settings_of({folder / "of.ini", "a.pov"});  // what a command line is there for
    CHECK(over.input_file == "a.pov");
    CHECK(over.notes.empty());
}

TEST_CASE("a number of threads beyond the range is told", "[app][options]")
{
    CHECK(settings_of({"+WT512"}).notes.empty());
    CHECK(settings_of({"+WT9999"}).threads == 512);
    CHECK(settings_of({"+WT9999"}).notes == Words{"Work_Threads is 1 to 512: 9999 counts as 512"});
    CHECK(settings_of({"+WT0"}).notes.size() == 1);
}

TEST_CASE("a lone dash is told how standard input is named", "[app][options]")
{
    CHECK_THROWS_WITH(settings_of({"-"}), Catch::Contains("+I- reads the scene from standard input"));
}
