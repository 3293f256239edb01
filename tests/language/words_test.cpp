#include "language/places/place_words.h"
#include "parser/lexer/lexer.h"
#include "parser/parse.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

// Completion offers what the grammar reads, and all of it: each reserved word is tried at each place.
using parser::Kind;

namespace {

const std::string kHead = "#version 3.7; global_settings { assumed_gamma 1 }\n";

/// A place where the items of a block stand: the text in front of it. What begins such a block, or goes on with one of
/// its items, is offered there too: `also`.
struct Spot {
    Kind block = Kind::EndOfText, outer = Kind::EndOfText;
    std::string before;
    std::vector<std::string> also;
};

#define PICTURE "\"" WHITTLE_SCENES "/pigment/leaf.png\""

std::string in_object(const std::string& items) { return "sphere { 0, 1 " + items; }
std::string in_pigment(const std::string& items) { return in_object("pigment { " + items); }

std::vector<Spot> settings_and_lights()
{
    return {
        {Kind::GlobalSettings, {}, "global_settings {", {}},
        {Kind::Camera, {}, "camera {", {}},
        {Kind::LightSource, {}, "light_source { 0, rgb 1", {"light_source { 0,"}},
        {Kind::LightGroup, {}, "light_group {", {}},
        {Kind::Background, {}, "background {", {}},
        {Kind::Fog, {}, "fog {", {}},
        {Kind::Rainbow, {}, "rainbow { direction x angle 40 width 5 distance 9 color_map { [0 rgb 1] [1 rgb 1] }", {}},
        {Kind::SkySphere, {}, "sky_sphere {", {}},
        {Kind::Photons, {}, in_object("photons {"), {}},
        {Kind::Photons, Kind::LightSource, "light_source { 0, rgb 1 photons {", {}},
        {Kind::Photons, Kind::GlobalSettings, "global_settings { photons {", {}},
        {Kind::Radiosity, {}, in_object("radiosity {"), {}},
        {Kind::Radiosity, Kind::GlobalSettings, "global_settings { radiosity {", {}},
        {Kind::Subsurface, Kind::GlobalSettings, "global_settings { subsurface {", {}},
        {Kind::LooksLike,
         {},
         "light_source { 0, rgb 1 looks_like {",
         {"light_source { 0, rgb 1 looks_like { sphere { 0, 1 }"}},
        {Kind::ProjectedThrough,
         {},
         "light_source { 0, rgb 1 projected_through {",
         {"light_source { 0, rgb 1 projected_through { sphere { 0, 1 }"}},
        {Kind::Default, {}, "#default {", {}},
    };
}

std::vector<Spot> looks()
{
    return {
        {Kind::Texture, {}, in_object("texture {"), {in_object("texture { agate")}},
        {Kind::InteriorTexture, {}, in_object("interior_texture {"), {in_object("interior_texture { agate")}},
        {Kind::Material, {}, in_object("material {"), {}},
        {Kind::Pigment, {}, in_pigment(""), {in_pigment("checker")}},
        {Kind::Normal, {}, in_object("normal {"), {in_object("normal { checker")}},
        {Kind::Finish, {}, in_object("finish {"), {}},
        {Kind::Reflection, Kind::Finish, in_object("finish { reflection { 0, 1"), {in_object("finish { reflection {")}},
        {Kind::Irid, Kind::Finish, in_object("finish { irid { 0.2"), {}},
        {Kind::Subsurface, Kind::Finish, in_object("finish { subsurface {"), {}},
        {Kind::Interior, {}, in_object("interior {"), {}},
        {Kind::Media, {}, "media {", {}},
        {Kind::Scattering, {}, "media { scattering { 1, rgb 1", {"media { scattering { 1"}},
        {Kind::Density, {}, "media { density {", {"media { density { checker"}},
        {Kind::ColorMap, {}, in_pigment("granite color_map { [0"), {in_pigment("granite color_map {")}},
        {Kind::PigmentMap,
         {},
         in_pigment("granite pigment_map { [0"),
         {in_pigment("granite pigment_map { [0 checker"), in_pigment("granite pigment_map {")}},
        {Kind::NormalMap,
         {},
         in_object("normal { granite normal_map { [0"),
         {in_object("normal { granite normal_map { [0 checker")}},
        {Kind::TextureMap,
         {},
         in_object("texture { granite texture_map { [0"),
         {in_object("texture { granite texture_map { [0 agate")}},
        {Kind::DensityMap,
         {},
         "media { density { granite density_map { [0",
         {"media { density { granite density_map { [0 checker"}},
        {Kind::ImageMap, {}, in_pigment("image_map { " PICTURE), {in_pigment("image_map {")}},
        {Kind::BumpMap, {}, in_object("normal { bump_map { " PICTURE), {in_object("normal { bump_map {")}},
        {Kind::MaterialMap,
         {},
         in_object("texture { material_map { " PICTURE),
         {in_object("texture { material_map {")}},
        {Kind::ImagePattern, {}, in_pigment("image_pattern { " PICTURE), {in_pigment("image_pattern {")}},
        {Kind::Slope, {}, in_pigment("slope {"), {in_pigment("slope { x")}},
        {Kind::Pattern,
         Kind::Function,
         "#declare F = function { pattern {",
         {"#declare F = function { pattern { agate"}},
        {Kind::Object,
         Kind::Pigment,
         in_pigment("object {"),
         {in_pigment("object { sphere { 0, 1 }"), in_object("texture { object { sphere { 0, 1 }"),
          in_object("normal { object { sphere { 0, 1 }")}},
        {Kind::Tiles, {}, in_object("texture { tiles {"), {in_object("texture { tiles { texture { }")}},
        {Kind::PigmentPattern, {}, in_pigment("pigment_pattern {"), {in_pigment("pigment_pattern { checker")}},
        {Kind::Bokeh, {}, "camera { bokeh {", {}},
        {Kind::Location, {}, "camera { user_defined location {", {}},
        {Kind::Direction, {}, "camera { user_defined direction {", {}},
        {Kind::UserDefined, {}, in_pigment("user_defined {"), {}},
        {Kind::Potential, {}, in_pigment("potential { blob { sphere { 0, 1, 1 } }"), {in_pigment("potential {")}},
        {Kind::MeshCamera,
         {},
         "camera { mesh_camera { 1, 0",
         {"camera { mesh_camera { 1, 0 mesh { triangle { 0, x, y } }"}},
        {Kind::Warp,
         {},
         in_pigment("granite warp {"),
         {in_pigment("granite warp { repeat x"), in_pigment("granite warp { black_hole 0, 1"),
          in_pigment("granite warp { turbulence 1"), in_pigment("granite warp { cylindrical"),
          in_pigment("granite warp { toroidal")}},
    };
}

std::vector<Spot> solids()
{
    return {
        {Kind::Transform, {}, in_object("transform {"), {}},
        {Kind::ContainedBy, {}, "isosurface { function { x } contained_by {", {}},
        {Kind::Sphere, Kind::ContainedBy, "isosurface { function { x } contained_by { sphere { 0, 1", {}},
        {Kind::Box, Kind::ContainedBy, "isosurface { function { x } contained_by { box { 0, 1", {}},
        {Kind::ClippedBy, {}, in_object("clipped_by {"), {in_object("clipped_by { sphere { 0, 1 }")}},
        {Kind::BoundedBy, {}, in_object("bounded_by {"), {in_object("bounded_by { sphere { 0, 1 }")}},
        {Kind::Sphere, {}, in_object(""), {}},
        {Kind::Box, {}, "box { 0, 1", {}},
        {Kind::Plane, {}, "plane { y, 0", {}},
        {Kind::Disc, {}, "disc { 0, y, 1", {}},
        {Kind::Polygon, {}, "polygon { 4, 0, x, y, 0", {}},
        {Kind::Triangle, {}, "triangle { 0, x, y", {}},
        {Kind::SmoothTriangle, {}, "smooth_triangle { 0, z, x, z, y, z", {}},
        {Kind::Superellipsoid, {}, "superellipsoid { <1, 1>", {}},
        {Kind::Ovus, {}, "ovus { 2, 1", {}},
        {Kind::Lemon, {}, "lemon { 0, 0.3, y, 0.3, 2", {}},
        {Kind::Quadric, {}, "quadric { <1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -1", {}},
        {Kind::Cubic, {}, "cubic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1>", {}},
        {Kind::Quartic, {}, "quartic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1>", {}},
        {Kind::Poly, {}, "poly { 2, <1,0,0,0,1,0,0,1,0,-1>", {}},
        {Kind::Polynomial, {}, "polynomial { 2, xyz(2,0,0):1", {"polynomial { 2,"}},
        {Kind::Cylinder, {}, "cylinder { 0, y, 1", {}},
        {Kind::Cone, {}, "cone { 0, 1, y, 0", {}},
        {Kind::Torus, {}, "torus { 2, 1", {}},
        {Kind::Prism, {}, "prism { 0, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0>", {"prism {"}},
        {Kind::Lathe, {}, "lathe { 2, <0, 0>, <1, 1>", {"lathe {"}},
        {Kind::Sor, {}, "sor { 4, <1, -1>, <1, 0>, <1, 1>, <1, 2>", {}},
        {Kind::SphereSweep, {}, "sphere_sweep { linear_spline 2, 0, 1, x, 1", {"sphere_sweep {"}},
        {Kind::Blob, {}, "blob { sphere { 0, 1, 1 }", {}},
        {Kind::Sphere, Kind::Blob, "blob { sphere { 0, 1, 1", {"blob { sphere { 0, 1,"}},
        {Kind::Cylinder, Kind::Blob, "blob { cylinder { 0, y, 1, 1", {"blob { cylinder { 0, y, 1,"}},
        {Kind::Text,
         {},
         "text { ttf \"/usr/share/povray-3.7/include/timrom.ttf\" \"a\" 1, 0",
         {"text {", "text { ttf \"/usr/share/povray-3.7/include/timrom.ttf\""}},
        {Kind::HeightField, {}, "height_field { " PICTURE, {"height_field {"}},
        {Kind::Isosurface, {}, "isosurface { function { x }", {"isosurface {"}},
        {Kind::Parametric,
         {},
         "parametric { function { u } function { v } function { 0 } <0, 0>, <1, 1>",
         {"parametric {"}},
        {Kind::JuliaFractal, {}, "julia_fractal { <0, 0, 0, 0>", {}},
        {Kind::BicubicPatch,
         {},
         "bicubic_patch { type 1 flatness 0 u_steps 2 v_steps 2 0,x,y,z, 0,x,y,z, 0,x,y,z, 0,x,y,z",
         {"bicubic_patch {", "bicubic_patch { type 1"}},
        {Kind::Mesh, {}, "mesh { triangle { 0, x, y }", {"mesh { obj \"none.obj\""}},
        {Kind::Mesh2,
         {},
         "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2> }",
         {"mesh2 {", "mesh2 { vertex_vectors { 3, 0, x, y }"}},
        {Kind::Union, {}, "union { sphere { 0, 1 }", {}},
        {Kind::Merge, {}, "merge { sphere { 0, 1 } sphere { x, 1 }", {}},
        {Kind::Intersection, {}, "intersection { sphere { 0, 1 } sphere { x, 1 }", {}},
        {Kind::Difference, {}, "difference { sphere { 0, 1 } sphere { x, 1 }", {}},
        {Kind::Object, {}, "object { sphere { 0, 1 }", {"object {"}},
        {Kind::Composite, {}, "composite { sphere { 0, 1 }", {}},
        {Kind::TextureList,
         Kind::Mesh,
         "mesh { triangle { 0, x, y texture_list {",
         {"mesh { obj \"none.obj\" texture_list {"}},
        {Kind::TextureList, Kind::Mesh2, "mesh2 { vertex_vectors { 3, 0, x, y } texture_list { 1", {}},
        {Kind::Array, {}, "#declare A = array[1] {", {}},
        {Kind::Dictionary, {}, "#declare D = dictionary {", {"#declare D = dictionary { .A:"}},
        {Kind::Spline, {}, "#declare S = spline {", {}},
        {Kind::Function, {}, "#declare F = function {", {}},
    };
}

std::vector<Spot> spots()
{
    std::vector<Spot> all = settings_and_lights();
    for (const auto& more : {looks(), solids()}) all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// Whether the grammar reads a word at a place; what it lacks then stands in the line below.
bool reads(const std::string& before, const std::string& word)
{
    try {
        parser::parse_text(fmt::format("{}{}\n{}\n}}", kHead, before, word), "t.pov", {});
    } catch (const parser::Error& error) {
        const scene::Message& first = error.messages().front();
        const bool there = first.place.at.line == 3 && first.place.at.column == 1;
        return !(there && (first.text.find(fmt::format("found '{}'", word)) != std::string::npos ||
                           first.text.find(fmt::format("'{}' is n", word)) != std::string::npos));
    }
    return true;
}

std::vector<std::string> all_words()
{
    std::vector<std::string> all;
    for (std::size_t i = 0; i < parser::kKindCount; ++i) {
        const std::string word(parser::spelling(static_cast<Kind>(i)));
        if (parser::keyword_of(word) == static_cast<Kind>(i)) all.push_back(word);
    }
    return all;
}

/// Words of numbers, vectors and texts are offered where a value is asked for.
bool begins_expression(const std::string& word)
{
    using parser::LexicalClass;
    const LexicalClass kind = parser::lexical_class(parser::keyword_of(word));
    return kind != LexicalClass::Other && kind != LexicalClass::Color;
}

/// Read for scenes of the nineties, or of every block of a kind though it means something in one alone: not offered.
const std::set<std::string> kSilent = {
    "alpha",        "blue",   "bump_size",   "caustics",      "color",       "color_map", "component",  "composite",
    "density_map",  "dtag",   "facets",      "filter",        "green",       "hierarchy", "ior",        "light_group",
    "light_source", "offset", "pigment_map", "premultiplied", "quick_color", "red",       "refraction", "repeat",
    "rgb",          "rgbf",   "rgbft",       "rgbt",          "split_union", "srgb",      "srgbf",      "srgbft",
    "srgbt",        "sturm",  "texture",     "transmit",      "use_alpha",   "uv_mapping"};

}  // namespace

TEST_CASE("completion offers the words that the grammar reads", "[places][words]")
{
    const std::vector<std::string> words = all_words();
    REQUIRE(words.size() > 400);
    for (const Spot& spot : spots()) {
        const std::vector<std::string> offered = language::block_words(spot.block, spot.outer);
        INFO(spot.before);
        REQUIRE_FALSE(reads(spot.before, "no_such_word"));
        std::vector<std::string> refused, untold;
        for (const std::string& word : words) {
            const bool known = std::find(offered.begin(), offered.end(), word) != offered.end();
            const bool taken = reads(spot.before, word);
            const bool elsewhere = known && !taken &&
                                   std::any_of(spot.also.begin(), spot.also.end(),
                                               [&](const std::string& before) { return reads(before, word); });
            if (known && !taken && !elsewhere) refused.push_back(word);
            if (taken && !known && !begins_expression(word) && !kSilent.contains(word)) untold.push_back(word);
        }
        if (!refused.empty() || !untold.empty())
            fmt::print("{}\n   refused {}\n   untold {}\n", spot.before, fmt::join(refused, " "),
                       fmt::join(untold, " "));
        CHECK(refused == std::vector<std::string>{});
        CHECK(untold == std::vector<std::string>{});
    }
}

TEST_CASE("completion offers what may stand behind a keyword", "[places][words]")
{
    const auto behind = [](Kind keyword, Kind block) {
        return language::words_behind(keyword, block, Kind::EndOfText);
    };
    using Words = std::vector<std::string>;
    CHECK(behind(Kind::Diffuse, Kind::Finish) == Words{"albedo"});
    CHECK(behind(Kind::Charset, Kind::GlobalSettings) == Words{"ascii", "utf8", "sys"});
    CHECK(behind(Kind::DensityFile, Kind::Pigment) == Words{"df3"});
    CHECK(behind(Kind::Roughness, Kind::Finish).empty());
}

TEST_CASE("each block that has words is among those that are tried", "[places][words]")
{
    const std::vector<Spot> tried = spots();
    for (std::size_t i = 0; i < parser::kKindCount; ++i) {
        const Kind kind = static_cast<Kind>(i);
        if (language::block_words(kind, Kind::EndOfText).empty()) continue;
        INFO(parser::spelling(kind));
        CHECK(std::any_of(tried.begin(), tried.end(), [&](const Spot& spot) { return spot.block == kind; }));
    }
}
