// What is written to a terminal, and to one of another encoding than UTF-8.
#include "tests/support/run_program.h"
#include "tests/support/scoped_variable.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <cstdlib>

namespace {

/// Standard error of the program where that is a terminal.
std::string shown_on_terminal(const support::TemporaryFolder& folder, const std::vector<std::string>& words,
                              const std::string& program = WHITTLE_PROGRAM)
{
    const int master = posix_openpt(O_RDWR | O_NOCTTY);
    REQUIRE(master >= 0);
    REQUIRE((grantpt(master) == 0 && unlockpt(master) == 0));
    const int slave = open(ptsname(master), O_RDWR | O_NOCTTY);
    REQUIRE(slave >= 0);
    support::RunningProgram(folder.path(), program, words, "", slave).wait();
    fcntl(master, F_SETFL, O_NONBLOCK);
    std::string text;
    char block[4096];
    for (ssize_t count; (count = read(master, block, sizeof block)) > 0;)
        text.append(block, static_cast<std::size_t>(count));
    close(slave);
    close(master);
    return text;
}

}  // namespace

TEST_CASE("source lines are shown as they are on a terminal of UTF-8 alone", "[program]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "u.pov", "// begin\n#declare A = \"gr\xC3\xBC\xC3\x9F\" shpere { }\n");
    support::ScopedVariable no_type("LC_CTYPE", std::nullopt), no_language("LANG", std::nullopt);
    {
        support::ScopedVariable locale("LC_ALL", "C.UTF-8");
        CHECK_THAT(shown_on_terminal(folder, {"u.pov", "--check"}), Catch::Contains("\"gr\xC3\xBC\xC3\x9F\" shpere"));
        CHECK_THAT(support::run_program(folder.path(), WHITTLE_PROGRAM, {"u.pov", "--check"}).err,
                   Catch::Contains("\"gr??\" shpere"));
    }
    support::ScopedVariable locale("LC_ALL", "C");
    CHECK_THAT(shown_on_terminal(folder, {"u.pov", "--check"}), Catch::Contains("\"gr??\" shpere"));
}

TEST_CASE("reading that takes long tells on a terminal which loop or macro it is in", "[program]")
{
    const support::TemporaryFolder folder, other;
    for (const support::TemporaryFolder* one : {&folder, &other})
        support::write_text(*one / "m.pov",
                            "#version 3.7;\n#macro Long()\n #while (1) #declare A = concat(\"a\", \"b\"); "
                            "#end\n#end\nLong()\n");
    const std::string timeout = "/usr/bin/timeout";
    const std::vector<std::string> words = {"6", WHITTLE_PROGRAM, "m.pov"};
    support::RunningProgram piped(other.path(), timeout, words);  // at the same time
    CHECK_THAT(shown_on_terminal(folder, words, timeout), Catch::Contains("\rreading, 5 s: in loop #while, m.pov:3:2"));
    CHECK(piped.wait().err.find("reading,") == std::string::npos);
}
