// whittle info --section: drawings read back as other programs read them, and what is said where there is none.
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>

namespace {

using support::Ended;
using support::run_program;
using support::text_of;
using support::write_text;

constexpr double kHalfTurn = 3.14159265358979323846;

constexpr const char* kCutScene =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "#declare Ring = difference { cylinder { 0, 2*y, 1 } cylinder { -y, 3*y, 0.5 } pigment { rgb x } }\n"
    "#declare Block = box { <2, 0, 0>, <3, 2, 3> pigment { rgb z } }\n"
    "object { Ring }\n"
    "object { Block }\n"
    "plane { y, 0 pigment { rgb 1 } }\n"
    "light_source { <3, 5, -5> rgb 1 }\n";

struct Drawn {
    std::string color;
    int loops = 0;
    double area = 0.0;
};

/// Twice the area of what a point's loop gains by it.
double cross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

/// By the group's name: path data of moves, lines and ends.
std::map<std::string, Drawn> groups_of(const std::string& svg)
{
    std::map<std::string, Drawn> out;
    for (std::size_t at = svg.find("<g id=\""); at != std::string::npos; at = svg.find("<g id=\"", at + 1)) {
        const std::size_t name = at + 7, name_end = svg.find('"', name);
        const std::size_t color = svg.find("fill=\"", name_end) + 6;
        Drawn& drawn = out[svg.substr(name, name_end - name)];
        drawn.color = svg.substr(color, 7);
        const std::size_t data = svg.find(" d=\"", color) + 4, data_end = svg.find('"', data);
        const char* text = svg.data() + data;
        double x0 = 0.0, y0 = 0.0, x = 0.0, y = 0.0;
        while (text < svg.data() + data_end) {
            const char command = *text++;
            if (std::strchr(" \n", command) != nullptr) continue;
            REQUIRE(std::strchr("MLZ", command) != nullptr);
            double nx = x0, ny = y0;
            if (command != 'Z') {
                char* rest = nullptr;
                nx = std::strtod(text, &rest);
                ny = std::strtod(rest, &rest);
                REQUIRE(rest > text);
                text = rest;
            }
            if (command == 'M') {
                ++drawn.loops;
                x0 = nx;
                y0 = ny;
            } else {
                drawn.area += 0.5 * cross(x, y, nx, ny);
            }
            x = nx;
            y = ny;
        }
    }
    return out;
}

/// By the layer's name: closed polylines.
std::map<std::string, Drawn> layers_of(const std::string& dxf)
{
    std::map<std::string, Drawn> out;
    std::istringstream in(dxf);
    std::string code, value, entity, layer;
    double x = 0.0, y = 0.0, first_x = 0.0, first_y = 0.0, px = 0.0, py = 0.0;
    int vertices = 0, ended = 0, closed = 0, polylines = 0;
    bool in_entities = false;
    const auto finish_vertex = [&] {
        if (entity != "VERTEX") return;
        if (vertices++ == 0) {
            first_x = x;
            first_y = y;
        } else {
            out[layer].area += 0.5 * cross(px, py, x, y);
        }
        px = x;
        py = y;
    };
    while (std::getline(in, code) && std::getline(in, value)) {
        const int group = std::stoi(code);
        if (group == 2 && value == "ENTITIES") in_entities = true;
        if (!in_entities) continue;
        if (group == 0) {
            finish_vertex();
            entity = value;
            if (entity == "POLYLINE") {
                ++polylines;
                vertices = 0;
            } else if (entity == "SEQEND") {
                out[layer].area += 0.5 * cross(px, py, first_x, first_y);
                ++out[layer].loops;
                CHECK(vertices >= 3);
                ++ended;
            }
        }
        if (group == 8) layer = value;
        if (group == 70 && entity == "POLYLINE") closed += value == "1";
        if (group == 10) x = std::stod(value);
        if (group == 20) y = std::stod(value);
    }
    CHECK(value == "EOF");
    CHECK(polylines == ended);
    CHECK(polylines == closed);
    return out;
}

Ended cut(const support::TemporaryFolder& folder, std::vector<std::string> words)
{
    words.insert(words.begin(), {"info", "s.pov"});
    return run_program(folder.path(), WHITTLE_PROGRAM, words);
}

}  // namespace

TEST_CASE("a cut is drawn as SVG and as DXF, an object a group and a layer", "[program][section]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "s.pov", kCutScene);
    const Ended ended = cut(folder, {"--section=y,0.5", "-o", "cut.svg", "-o", "cut.dxf"});
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    CHECK(folder.names() == std::vector<std::string>{"cut.dxf", "cut.svg", "s.pov"});
    CHECK_THAT(ended.err, Catch::Contains("left out: it has no end"));
    CHECK_THAT(ended.out, Catch::Contains("deviation") && Catch::Contains("cut.svg  2 objects"));
    const double ring = 0.75 * kHalfTurn, room = 0.01 * 3.0 * kHalfTurn;
    const std::string svg = text_of(folder / "cut.svg"), dxf = text_of(folder / "cut.dxf");
    const auto groups = groups_of(svg);
    REQUIRE(groups.size() == 2);
    CHECK(groups.at("Ring").color == "#ff0000");
    CHECK(groups.at("Ring").loops == 2);
    CHECK(groups.at("Ring").area == Approx(ring).margin(room));
    CHECK(groups.at("Block").color == "#0000ff");
    CHECK(groups.at("Block").loops == 1);
    CHECK(groups.at("Block").area == Approx(3.0).margin(1e-3));
    // From -1 to 3 and -1 to 3, y downward, with a fiftieth about it.
    CHECK_THAT(svg, Catch::Contains("viewBox=\"-1.08 -3.08 4.16 4.16\"") && Catch::Contains("fill-rule=\"evenodd\"") &&
                        Catch::Contains("width=\"4.16mm\""));
    const auto layers = layers_of(dxf);
    REQUIRE(layers.size() == 2);
    CHECK(layers.at("RING").loops == 2);
    CHECK(layers.at("RING").area == Approx(ring).margin(room));
    CHECK(layers.at("BLOCK").area == Approx(3.0).margin(1e-3));
    CHECK_THAT(dxf, Catch::Contains("AC1009") && !Catch::Contains("LWPOLYLINE"));
    CHECK(run_program(folder.path(), "/usr/bin/python3",
                      {"-c", "import sys, xml.dom.minidom; xml.dom.minidom.parse('cut.svg')"})
              .status == 0);
}

TEST_CASE("one declared object alone is cut, and told of as JSON", "[program][section]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "s.pov", kCutScene);
    const Ended ended = cut(folder, {"--section", "x,2.5", "--object=Block", "--json", "-o", "cut.svg"});
    INFO(ended.err);
    CHECK(ended.status == 0);
    CHECK(ended.err.empty());
    write_text(folder / "out.json", ended.out);
    CHECK(run_program(folder.path(), "/usr/bin/python3", {"-m", "json.tool", "out.json"}).status == 0);
    // The drawing's area is 5.99977 (a corner that the contour cuts off, well inside the tolerance of 0.01 by the
    // length of 10); the rays' is exact.
    CHECK_THAT(ended.out, Catch::Contains("\"object\":\"Block\",\"axis\":\"x\",\"value\":2.5,\"area\":"));
    CHECK_THAT(ended.out, Catch::Contains("\"area_by_rays\":6,"));
    CHECK(groups_of(text_of(folder / "cut.svg")).at("Block").area == Approx(6.0).margin(1e-3));
}

TEST_CASE("where there is no cut the file stays what it was, and the reason is told", "[program][section]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "s.pov", kCutScene);
    write_text(folder / "open.pov", "mesh { triangle { 0, x, y } }\nplane { y, 0 }\n");
    write_text(folder / "bad.pov", "sphere { 0, }\n");
    write_text(folder / "cut.svg", "old");
    const auto told = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "info");
        const Ended ended = run_program(folder.path(), WHITTLE_PROGRAM, words);
        INFO(words[1] << " " << words.back());
        CHECK(ended.status == 1);
        CHECK(ended.out.empty());
        CHECK(text_of(folder / "cut.svg") == "old");
        return ended.err;
    };
    using Catch::Contains;
    CHECK_THAT(told({"s.pov", "--section=y,7", "-o", "cut.svg"}),
               Contains("Ring: not cut: it reaches from y = 0 to 2") && Contains("y = 7 cuts nothing"));
    CHECK_THAT(told({"open.pov", "--section=y,0", "-o", "cut.svg"}),
               Contains("left out: nothing is inside of it") && Contains("left out: it has no end"));
    CHECK_THAT(told({"bad.pov", "--section=y,0", "-o", "cut.svg"}), Contains("bad.pov:1:"));
    CHECK_THAT(told({"s.pov", "--object=Nut", "--section=y,0", "-o", "cut.svg"}), Contains("'Nut'"));
    CHECK_THAT(told({"s.pov", "--object=Ring { }", "--section=y,0", "-o", "cut.svg"}), Contains("a declared name"));
    for (const char* plane : {"w,1", "y", "y,", "y,nan", "y,inf", "y,1e999", "y,1x", "1,y", "yy,1", "y=1", ",,"})
        CHECK_THAT(told({"s.pov", std::string("--section=") + plane, "-o", "cut.svg"}),
                   Contains("--section wants x, y or z and a number, as in y,0.5; found '" + std::string(plane) + "'"));
    CHECK_THAT(told({"s.pov", "--section=", "-o", "cut.svg"}), Contains("--section wants a value"));
    CHECK_THAT(told({"s.pov", "--section=y,1"}), Contains("where to?"));
    CHECK_THAT(told({"s.pov", "-o", "cut.svg"}), Contains("-o wants a --section"));
    CHECK_THAT(told({"s.pov", "--section=y,1", "-o", "cut.png"}), Contains(".svg or .dxf, not as 'cut.png'"));
    CHECK_THAT(told({"s.pov", "--section=y,1", "-o", "no/such/cut.svg"}), Contains("there is no folder"));
    CHECK_THAT(told({"s.pov", "--section=y,1", "-o", "/proc/cut.svg"}), Contains("cannot write '/proc/cut.svg'"));
    CHECK_THAT(told({"s.pov", "--section=y,1", "-o", "cut.svg", "--tolerance=0"}),
               Contains("--tolerance wants a number"));
    CHECK_THAT(told({"s.pov", "--section=y,1", "-o", "cut.svg", "--precision=0.1"}), Contains("does not go with"));
    CHECK(folder.names() == std::vector<std::string>{"bad.pov", "cut.svg", "open.pov", "s.pov"});
}
