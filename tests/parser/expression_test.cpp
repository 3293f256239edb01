#include "numbers/remainder.h"
#include "parser/stream/expressions/number_functions.h"
#include "parser/stream/expressions/text_functions.h"
#include "parser/stream/expressions/fixed_text.h"
#include "tests/parser/stream_support.h"

#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <fstream>
#include <random>

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
        if (found == wanted) {  // in a loop it is compiled at the second pass: nothing may change
            const std::string again = parser_test::debug_of("#for (Pass, 1, 4)\n" + program + "\n#debug \"\\n\"\n#end");
            CHECK(again == wanted + '\n' + wanted + '\n' + wanted + '\n' + wanted + '\n');
        }
        ++rows;
    }
    CHECK(rows > 100);
}

// Names change their type and their value between passes; what is compiled must notice.
TEST_CASE("a compiled expression follows its names", "[parser][expression]")
{
    CHECK(
        parser_test::debug_of(
            "#declare V=array[4]; #declare A=1; #for(I,0,3) #declare A=A+I; #debug str(A*2-1,0,0) #debug \" \" #end") ==
        "1 3 7 13 ");
    CHECK(parser_test::debug_of("#macro M(P) #local Q=P*2; #debug vstr(3,Q,\",\",0,0) #debug \" \" #end\n"
                                "M(1) M(2) M(<1,2,3>) M(<4,5>) M(3) M(x) M(4)") ==
          "2,0,0 4,0,0 2,4,6 8,10,0 6,0,0 2,0,0 8,0,0 ");
    CHECK(parser_test::debug_of(
              "#declare R=seed(1); #for(I,1,3) #debug str(rand(R)/(I-2+(I=2)*5),0,4) #debug \" \" #end") ==
          "-0.4220 0.0974 0.6659 ");
    CHECK(parser_test::debug_of("#declare A=array[3]{1,2,3}; #for(I,0,5) #if (I<3) #declare B=A[I]+I; #else #declare "
                                "B=-1; #end #debug str(B,0,0) #end") == "135-1-1-1");
    CHECK(parser_test::debug_of("#macro Op() +2 #end #for(I,1,3) #debug str(I Op(),0,0) #end") == "345");
    CHECK(parser_test::debug_of("#macro Two() I+1 #end #for(I,1,3) #debug str(2*Two(),0,0) #debug \" \" #end") ==
          "3 5 7 ");
}

// POV-Ray 3.7 prints "2 3 4".
TEST_CASE("an element given to a macro is given by reference in each pass of a loop", "[parser][expression]")
{
    CHECK(parser_test::debug_of("#version 3.7;\n#macro Inc(X) #declare X = X + 1; #end\n"
                                "#declare A = array[3]{1, 2, 3}; #declare I = 0;\n"
                                "#while (I < 3) Inc(A[I]) #declare I = I + 1; #end\n"
                                "#for (I, 0, 2) #debug str(A[I], 0, 0) #end") == "234");
}

TEST_CASE("a division by zero warns also where it is compiled, and once", "[parser][expression]")
{
    parser_test::NoGrammar grammar;
    parser::TokenStream stream({}, grammar);
    stream.open_text("#for(I,1,4) #declare A=1/(I-2); #end", "test.pov");
    while (stream.peek().kind != parser::Kind::EndOfText) stream.next();
    CHECK(stream.messages().size() == 1);
    parser::TokenStream each({}, grammar);
    each.open_text("#for(I,1,4) #declare A=I/0; #end", "test.pov");
    while (each.peek().kind != parser::Kind::EndOfText) each.next();
    CHECK(each.messages().size() == 1);
}

TEST_CASE("five components are single precision once they are stored", "[parser][expression]")
{
    const auto x_of = [](const std::string& text) { return parser_test::debug_of(text); };
    CHECK(x_of("#declare V=<4.47,1/3,0,0,pi>; #debug concat(str(V.x,0,10),\" \",str(V.y,0,10),\" "
               "\",str(V.transmit,0,10))") == "4.4699997902 0.3333333433 3.1415927410");
    CHECK(x_of("#declare V=<4.47,1/3,0,pi>; #debug str(V.x,0,10)") == "4.4700000000");
    CHECK(x_of("#declare V=<4.47,1/3,0,0,pi>+.1; #debug str(V.x,0,10)") == "4.5700001717");
    CHECK(x_of("#debug str(<4.47,1/3,0,0,pi>.x,0,10)") == "4.4700000000");
    CHECK(x_of("#declare A=array[1]{<4.47,1/3,0,0,pi>}; #debug str(A[0].x,0,10)") == "4.4699997902");
    CHECK(x_of("#macro M(X) #debug concat(str(X.x,0,10),\" \") #end M(<4.47,1/3,0,0,pi>) #for(I,1,3) "
               "M(<4.47,1/3,0,0,pi>) #declare V=<4.47,I,0,0,pi>; #debug concat(str(V.x,0,6),\" \") #end") ==
          "4.4699997902 4.4699997902 4.470000 4.4699997902 4.470000 4.4699997902 4.470000 ");
}

TEST_CASE("mod() of whole numbers is the library's", "[parser][expression]")
{
    std::mt19937_64 random(5);
    const auto whole = [&] {
        const std::uint64_t bits = random();
        return static_cast<double>(static_cast<std::int64_t>(bits >> (10 + bits % 54))) * (random() % 2 ? 1.0 : -1.0);
    };
    for (int i = 0; i < 200'000; ++i) {
        const double b = whole(), times = static_cast<double>(random() % 1000);
        const double a = i % 5 == 0 ? b * times : i % 7 == 0 ? whole() / 8.0 : whole();
        const double ours = numbers::fmod(a, b), theirs = std::fmod(a, b);
        INFO(a << " and " << b);
        REQUIRE((std::isnan(theirs) ? std::isnan(ours)
                                    : std::bit_cast<std::uint64_t>(ours) == std::bit_cast<std::uint64_t>(theirs)));
    }
    CHECK(std::signbit(numbers::fmod(-6.0, 3.0)));
    CHECK(std::isnan(numbers::fmod(6.0, 0.0)));
    CHECK(std::isnan(numbers::fmod(INFINITY, 3.0)));
    CHECK(numbers::fmod(5.0, INFINITY) == 5.0);
}

TEST_CASE("numbers are written as the library writes them", "[parser][expression]")
{
    std::mt19937_64 random(9);
    const auto number = [&](int kind) {
        const auto whole = static_cast<double>(random() % 1'000'000);
        switch (kind) {
        case 0: return std::bit_cast<double>(random());
        case 1: return whole / static_cast<double>(1 << random() % 20);  // ties
        case 2: return whole / 1000.0;
        default: return std::ldexp(static_cast<double>(random() >> 11), -static_cast<int>(random() % 140));
        }
    };
    int written = 0;
    constexpr int kNumbers = 200'000;
    for (int i = 0; i < kNumbers; ++i) {
        const int precision = static_cast<int>(random() % 20);
        const double value = number(i % 4) * (random() % 2 ? 1.0 : -1.0);
        std::array<char, parser::kFixedText> ours;
        char* const end = ours.data() + ours.size();
        const char* const begin = parser::fixed_text(end, value, precision);
        if (!begin) continue;
        ++written;
        std::array<char, 400> theirs;
        const auto result =
            std::to_chars(theirs.data(), theirs.data() + theirs.size(), value, std::chars_format::fixed, precision);
        REQUIRE(std::string_view(begin, static_cast<std::size_t>(end - begin)) ==
                std::string_view(theirs.data(), static_cast<std::size_t>(result.ptr - theirs.data())));
    }
    CHECK(written > kNumbers / 2);
    CHECK(parser::number_text(-0.0, -6, 2) == "-00.00");
    CHECK(parser::number_text(2.5, 6, 0) == "     2");
    CHECK(parser::number_text(-1.25, -8, 1) == "-00001.2");
}
