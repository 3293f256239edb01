#include "tests/parser/stream_support.h"

#include <catch2/catch.hpp>

#include <fstream>

// Each row: an expression and what POV-Ray 3.7 prints for it (data/make_expressions.py).
TEST_CASE("expressions have POV-Ray's values", "[parser][expression]")
{
    std::ifstream table(WHITTLE_TEST_DATA "/expressions.csv");
    REQUIRE(table);
    std::string line;
    std::getline(table, line);
    int rows = 0;
    while (std::getline(table, line)) {
        const std::size_t first = line.find('\t'), second = line.find('\t', first + 1);
        const std::string kind = line.substr(0, first), text = line.substr(first + 1, second - first - 1);
        const std::string wanted = line.substr(second + 1);
        INFO(text);
        std::string program;
        if (kind == "float") program = "#debug str(" + text + ",0,9)";
        else if (kind == "tuple") program = "#declare Q=" + text + ";\n#debug vstr(5,Q,\"|\",0,9)";
        else program = "#debug " + text;
        std::string found;
        try {
            found = parser_test::debug_of(program);
        } catch (const parser::Error& error) {
            found = error.what();
        }
        CHECK(found == wanted);
        ++rows;
    }
    CHECK(rows > 100);
}
