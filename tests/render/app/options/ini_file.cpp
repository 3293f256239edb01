#include "render/app/options/ini_file.h"

#include "render/app/options/command_line.h"
#include "tests/support/scoped_variable.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <fstream>

using namespace app;

namespace {

Settings ini_settings(const std::string& text, const std::string& section = "")
{
    Settings settings;
    apply_ini_text(settings, text, section, "test.ini");
    return settings;
}

}  // namespace

TEST_CASE("an INI file has one option a line, with comments", "[app][ini]")
{
    const Settings s =
        ini_settings("; comment\nWidth = 9 ; nine\n  Height=7 # seven\n\nOutput_File_Name=\"a ; b.png\"\r\n");
    CHECK(s.width == 9);
    CHECK(s.height == 7);
    CHECK(s.output_file == "a ; b.png");
    CHECK(ini_settings("Width=9 Height=7").height == 600);
}

TEST_CASE("lines of switches, lists of values", "[app][ini]")
{
    const Settings s = ini_settings("+W9 +H7 -A\nLibrary_Path=one,\"two, three\"\nWidth=9,8\n'my scene.pov'");
    CHECK(s.width == 8);
    CHECK(s.library_path == std::vector<std::string>{"one", "two, three"});
    CHECK(s.input_file == "my scene.pov");
}

TEST_CASE("a section applies only where it is asked for", "[app][ini]")
{
    const std::string text = "Width=1\n[Small]\nWidth=2\n[large]\nWidth=3\n[small]\nHeight=5\n";
    CHECK(ini_settings(text).width == 1);
    CHECK(ini_settings(text, "small").width == 2);
    CHECK(ini_settings(text, "small").height == 5);
    CHECK(ini_settings(text, "LARGE").width == 3);
    CHECK_THROWS_WITH(ini_settings(text, "other"), "test.ini: there is no section [other]");
    CHECK_THROWS_WITH(ini_settings(text, "smal"), "test.ini: there is no section [smal]; did you mean 'Small'?");
}

TEST_CASE("declared strings keep their quotes until they are read", "[app][ini]")
{
    const Settings s = ini_settings("Declare=a=2\nDeclare=b=\"two words\"");
    CHECK(s.declared_numbers.at("a") == 2.0);
    CHECK(s.declared_strings.at("b") == "two words");
}

TEST_CASE("an error in an INI file names file and line; an obsolete option is a remark", "[app][ini]")
{
    CHECK_THROWS_WITH(ini_settings("Width=9\nWidht=9\n"), "test.ini:2: unknown option 'Widht'; did you mean 'Width'?");
    const Settings s = ini_settings("Buffer_Output=on\nWidth=9");
    CHECK(s.width == 9);
    CHECK(s.notes == std::vector<std::string>{"Buffer_Output is obsolete and has no effect"});
}

TEST_CASE("an INI file is found with or without its extension, also with a section", "[app][ini]")
{
    const support::TemporaryFolder folder;
    std::ofstream(folder / "sizes.ini") << "Height=11\n[a]\nWidth=22\n";
    for (const char* name : {"sizes", "sizes.ini", "sizes[a]", "sizes.ini[a]"}) {
        Settings settings;
        apply_command_line(settings, {folder / name});
        CHECK(settings.height == 11);
        CHECK(settings.width == (std::string(name).ends_with(']') ? 22 : 800));
    }
    Settings by_path;
    apply_command_line(by_path, {"+L" + folder.path(), "sizes"});
    CHECK(by_path.height == 11);
}

TEST_CASE("INI files that name each other are an error, not a hang", "[app][ini]")
{
    const support::TemporaryFolder folder;
    std::ofstream(folder / "a.ini") << "'" << (folder / "b.ini") << "'\n";
    std::ofstream(folder / "b.ini") << "'" << (folder / "a.ini") << "'\n";
    Settings settings;
    CHECK_THROWS_WITH(read_ini_file(settings, folder / "a.ini"), Catch::Contains("without end"));
}

TEST_CASE("the INI file that applies unnamed: the first of several places; its sizes default to 160x120", "[app][ini]")
{
    const support::TemporaryFolder folder;
    std::filesystem::create_directories(folder / ".povray/3.7");
    support::ScopedVariable home("HOME", folder.path()), none("POVINI", std::nullopt);
    std::ofstream(folder / ".povrayrc") << "Height=5\n";
    const bool installed = std::filesystem::exists("/etc/povray/3.7/povray.ini");
    const auto height = [] {
        Settings settings;
        read_default_ini_file(settings);
        return settings.height;
    };
    CHECK(height() == (installed ? 600 : 5));
    std::ofstream(folder / ".povray/3.7/povray.ini") << "Width=7\n";
    CHECK(height() == 120);
    std::ofstream(folder / "own.ini") << "Height=9\n";
    support::ScopedVariable own("POVINI", folder / "own.ini");
    CHECK(height() == 9);
    support::ScopedVariable missing("POVINI", folder / "gone.ini");
    CHECK(height() == 120);
}

TEST_CASE("any text is an INI file or an error that says so", "[app][ini]")
{
    const std::vector<std::string> pieces{"Width",
                                          "=",
                                          "9",
                                          "\n",
                                          "\n",
                                          " ",
                                          "\"",
                                          "'",
                                          ";",
                                          "#",
                                          "[",
                                          "]",
                                          "+W",
                                          "-",
                                          "+A0",
                                          ",",
                                          "Declare",
                                          "a",
                                          ".5",
                                          "\t",
                                          "\r",
                                          "Antialias",
                                          "on",
                                          "Include_Ini",
                                          "Library_Path",
                                          "/",
                                          "Output_File_Type",
                                          std::string(1, '\0'),
                                          "\xFF",
                                          "%",
                                          "+F",
                                          "+K",
                                          "--",
                                          "=\n",
                                          "Start_Row"};
    for (std::uint32_t seed = 0; seed < 20'000; ++seed) {
        std::uint32_t state = seed * 2654435761u + 1u;
        std::string text;
        for (int i = 0; i < 24; ++i) {
            state = state * 1664525u + 1013904223u;
            text += pieces[(state >> 16) % pieces.size()];
        }
        INFO("seed " << seed);
        try {
            ini_settings(text, seed % 2 ? "a" : "");
        } catch (const OptionError& error) {
            REQUIRE(std::string(error.what()).starts_with("test.ini:"));
        }
    }
}
