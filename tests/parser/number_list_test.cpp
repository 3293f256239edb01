#include "parser/lexer/number_blocks.h"
#include "parser/lexer/short_number.h"
#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <array>
#include <charconv>
#include <cstring>
#include <random>

using grammar_test::error_of;
using grammar_test::parsed;

namespace {

/// The text with every '<' followed by something that no list of literals has: read by the general way.
std::string in_general(const std::string& text)
{
    std::string out;
    for (const char c : text) {
        out += c;
        if (c == '<') out += "/**/";
    }
    return out;
}

/// The values of a list that is one as a whole; empty if it is none.
std::vector<double> values_of(parser::Kind keyword, const std::string& text)
{
    std::vector<double> values;
    parser::NumberList list;
    const char* first = nullptr;
    const char* const end =
        parser::read_number_list(keyword, text.data(), text.data() + text.size(), values, list, first);
    if (end == nullptr) CHECK(values.empty());
    else CHECK(values.size() == std::size_t{list.items} * list.stride);
    return values;
}

}  // namespace

TEST_CASE("literal lists of meshes mean what the same text means token by token", "[parser][mesh]")
{
    const std::string points =
        "vertex_vectors { 4, <0,0,0>, <1,0,-0.0> <.5 , 1.e0,- 2>,\n<0.1e1,1e-3,12345678901234567890> }";
    for (const std::string& text : std::vector<std::string>{
             "mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0> } }",
             "mesh { triangle { <0,0,0> <1,0,-0>\t<0,1e2,0> uv_vectors <0,0> <1,0> <0,1> } }",
             "mesh { smooth_triangle { <0,0,0>,<0,0,1>, <1,0,0>,<0,0,1>, <0,1,0>,<0,1,1> texture { pigment { rgb 1 } } "
             "} }",
             "mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0> } smooth_triangle{<0,0,0>,<0,0,1>, <1,0,0>,<0,0,1>, "
             "<0,1,0>,<0,1,1>}\n triangle { <0,0,0> <1,0,-0> <0,1e2,0> } inside_vector y }",
             "mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0> } triangle { <0,0,1>, <1,0,0>, <0,1,0> texture { pigment { "
             "rgb 1 } } } triangle { <0,0,2>, <1,0,0>, <0,1,0> } pigment { rgb 1 } }",
             "mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0> } #declare A = 2; triangle { <A,0,1>, <1,0,0>, <0,1,0> } "
             "smooth_triangle { <0,0,0>,<0,0,1>, <1,0,0>,<0,0,1>, <0,1,0>,<0,1,A> } }",
             "#macro M(B) mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0> } triangle { <B,0,1>, <1,0,0>, <0,1,0> } } #end "
             "M(1) M(2) #for (I, 1, 3) mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0> } translate I*x } #end",
             "triangle { <0,0,0>, <1,0,0>, <0,1,0> pigment { rgb 1 } }",
             "smooth_triangle { <0,0,0>,<0,0,2>, <1,0,0>,<0,0,1>, <0,1,0>,<0,1,1> }",
             "mesh2 { " + points + " face_indices { 2, <0,1,2>, <1,2,3> } }",
             "mesh2 { " + points +
                 " normal_vectors { 1, <0,0,1> } face_indices { 1 <0,1,2> } normal_indices { 1, <0,0,0>, } }",
             "mesh2 { " + points +
                 " uv_vectors { 2, <0,0.5>, <1,0> } face_indices { 1, <0,1,2> } uv_indices { 1, <0,1,1> } }",
             "mesh2 { " + points +
                 " texture_list { 2, texture { pigment { rgb 1 } } texture { pigment { rgb x } } }"
                 " face_indices { 4, <0,1,2>, 1, <1,2,3>, 0, 1, 1, <0,1,3>, <0,2,3>, 1, 0, } }",
         }) {
        INFO(text);
        CHECK(scene::dump(parsed(text)) == scene::dump(parsed(in_general(text))));
    }
}

TEST_CASE("what is no plain list of literals is read by the general way", "[parser][mesh]")
{
    using parser::Kind;
    CHECK(values_of(Kind::VertexVectors, " 2, <1,2,3>, <4,5,6> }").size() == 6);
    CHECK(values_of(Kind::UvVectors, "1 <1,2>, }").size() == 2);
    CHECK(values_of(Kind::FaceIndices, "2 <1,2,3>, 4, <5,6,7> }") ==
          std::vector<double>{1, 2, 3, 4, -1, -1, 5, 6, 7, -1, -1, -1});
    CHECK(values_of(Kind::Triangle, "<1,2,3>, <4,5,6> <7,8,9> }").size() == 9);
    for (const char* const text : {"2, <1,2,3> }", "1, <1,2> }", "1, <1,2,3>*2 }", "1, <1,2,N> }", "1, <1,2,3 4> }",
                                   "1, <1,2,3>", "N, <1,2,3> }", "1.5, <1,2,3> }", "1, <1,2,1.2.3> }", "1, <1,2,1e> }",
                                   "1, <1,2,--3> }", "1, /* x */ <1,2,3> }", "-1 }", ""}) {
        INFO(text);
        CHECK(values_of(Kind::VertexVectors, text).empty());
    }
    for (const char* const text :
         {"<1,2,3>, <4,5,6>, <7,8,9> * 2 }", "<1,2,3>, <4,5,6> }", "<1,2,3>, <4,5,6>, <7,8,9>.x }"}) {
        INFO(text);
        CHECK(values_of(Kind::Triangle, text).empty());
    }
}

TEST_CASE("numbers of lists are rounded as the library rounds them", "[parser][mesh]")
{
    std::mt19937_64 random(5);
    for (int i = 0; i < 20000; ++i) {
        std::string number;
        const auto digits = [&](std::uint64_t most) {
            for (std::uint64_t left = random() % (most + 1); left > 0; --left)
                number += static_cast<char>('0' + random() % 10);
        };
        digits(static_cast<std::uint64_t>(i % 25));
        if (random() % 2 != 0) number += '.';
        digits(12);
        if (number.empty() || number == ".") continue;
        if (random() % 3 == 0) number += (random() % 2 != 0 ? "e-" : "E") + std::to_string(random() % 40);
        double expected = 0.0;
        std::from_chars(number.data(), number.data() + number.size(), expected);
        INFO(number);
        const std::vector<double> read = values_of(parser::Kind::UvVectors, "1 <-" + number + "," + number + ">}");
        REQUIRE(read.size() == 2);
        const double negative = -expected;
        REQUIRE(std::memcmp(&read[0], &negative, sizeof negative) == 0);
        REQUIRE(std::memcmp(&read[1], &expected, sizeof expected) == 0);
    }
}

TEST_CASE("messages about literal lists stand where they stood", "[parser][mesh]")
{
    const std::string points = "mesh2 { vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } ";
    for (const std::string& text : std::vector<std::string>{
             points + "face_indices { 2, <0,1,2>,\n <0,3,1> } }",
             points + "face_indices { 1, <0,-1,2> } }",
             points + "texture_list { 1, texture { } } face_indices { 2, <0,1,2>, 0, <0,1,2>, 0, 7, 0 } }",
             points + "face_indices { 1, <0,1,2>, 3 } }",
             points + "normal_vectors { 1, <0,0,1> } face_indices { 1, <0,1,2> } normal_indices { 1, <0,0,1> } }",
             std::string("box { vertex_vectors { 1, <0,0,0> } }"),
             std::string("mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0> sphere } }"),
             std::string(
                 "mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0> } triangle { <0,0,0>, <1,0,0>, <0,1,0> } sphere }"),
             std::string("mesh { triangle { <0,0,0>, <1,0,0>, <0,1,0> } triangle { <0,0,0>, <1,0,0> } }"),
         }) {
        INFO(text);
        // The comments that force the general way move columns: only what stands before the last line's '<' may differ.
        std::string spaced = text;
        for (std::size_t at = 0; (at = spaced.find('{', at)) != std::string::npos; ++at)
            if (at > 0 && spaced.compare(at, 2, "{ ") == 0) spaced.replace(at, 2, "{\f");
        REQUIRE_FALSE(error_of(text).empty());
        CHECK(error_of(text) == error_of(spaced));
        const std::string general = error_of(in_general(text));
        const auto words = [](const std::string& message) { return message.substr(message.find(": error: ") + 1); };
        CHECK(words(error_of(text)) == words(general));
    }
    CHECK(error_of(points + "face_indices { 2, <0,1,2>,\n <0,3,1> } }")
              .starts_with("2:8: error: an index of face_indices"));
    CHECK(error_of(points + "texture_list { 1, texture { } }\nface_indices { 1, <0,1,2>, 0, 7 } }")
              .starts_with("2:31: error: a texture index"));
}

TEST_CASE("a mesh begins with one token for its plain triangles", "[parser][mesh]")
{
    const auto read = [](const std::string& text, std::vector<double>& values) {
        parser::NumberList list;
        const char* first = nullptr;
        const char* const begin = text.data();
        const char* const end =
            parser::read_number_list(parser::Kind::Mesh, begin, begin + text.size(), values, list, first);
        if (end == nullptr) return std::string("none");
        CHECK(list.stride == 0);
        return std::to_string(list.items) + " up to" + std::string(end, begin + text.size());
    };
    std::vector<double> values;
    const std::string one = " triangle { <1,2,3>, <4,5,6>, <7,8,9> }";
    CHECK(read(one + " }", values) == "1 up to }");
    CHECK(values == std::vector<double>{9, 1, 2, 3, 4, 5, 6, 7, 8, 9});
    CHECK(read(one + " smooth_triangle{<1,2,3><0,0,1><4,5,6><0,0,1><7,8,9><0,0,1>} triangle { A }", values) ==
          "2 up to triangle { A }");
    CHECK(values.size() == 10 + 10 + 19);
    for (const char* const text :
         {"}", "", "triangle", "triangle {", "triangles { <1,2,3>, <4,5,6>, <7,8,9> }",
          "triangle { <1,2,3>, <4,5,6>, <7,8,9>", "smooth_triangle { <1,2,3>, <4,5,6>, <7,8,9> }",
          "triangle { <1,2,3>, <4,5,6>, <7,8,9> texture { T } }"}) {
        INFO(text);
        values.clear();
        CHECK(read(text, values) == "none");
        CHECK(values.empty());
    }
}

TEST_CASE("short numbers are what the library reads", "[parser][mesh]")
{
    std::mt19937 random(11);
    const auto upto = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most + 1)); };
    const auto digits = [&](int count) {
        std::string out;
        for (int i = 0; i < count; ++i) out += static_cast<char>('0' + upto(9));
        return out;
    };
    int read = 0;
    constexpr int kTexts = 20'000;
    for (int i = 0; i < kTexts; ++i) {
        std::string text = digits(upto(9));
        if (upto(3) > 0) text += "." + digits(upto(9));
        if (upto(3) == 0)
            text += std::string(upto(1) ? "e" : "E") + std::array{"", "+", "-"}[static_cast<std::size_t>(upto(2))] +
                    digits(upto(3));
        const std::string padded = text + std::array{",", ">", " ", "\n"}[static_cast<std::size_t>(upto(3))] +
                                   std::string(40, ' ');
        double value = -1.0, expected = -2.0;
        const char* const end = parser::short_number(padded.data(), value);
        if (!end) continue;
        ++read;
        INFO(text);
        const auto result = std::from_chars(padded.data(), padded.data() + padded.size(), expected);
        REQUIRE(end == result.ptr);
        REQUIRE(value == expected);
    }
    CHECK(read > kTexts / 2);
    double value = 0.0;
    for (const char* const text : {"123456789", "1.123456789", ".5", "1.", "1.e2", "1e", "1e+", "1e999", "1e-23", "",
                                   "x", "-1", "99999999.99999999"}) {
        INFO(text);
        CHECK(parser::short_number((text + std::string(40, ' ')).c_str(), value) == nullptr);
    }
}
