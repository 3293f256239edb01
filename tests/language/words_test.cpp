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

/// A place where the items of a block stand: the text in front of it.
struct Spot {
    Kind block = Kind::EndOfText, outer = Kind::EndOfText;
    std::string before;
};

const std::vector<Spot>& spots()
{
    const auto object = [](const std::string& items) { return "sphere { 0, 1 " + items; };
    const auto pigment = [&](const std::string& items) { return object("pigment { " + items); };
    static const std::vector<Spot> all = {
        {Kind::GlobalSettings, {}, "global_settings {"},
        {Kind::Camera, {}, "camera {"},
        {Kind::LightSource, {}, "light_source { 0, rgb 1"},
        {Kind::LightGroup, {}, "light_group {"},
        {Kind::Background, {}, "background {"},
        {Kind::Fog, {}, "fog {"},
        {Kind::Rainbow, {}, "rainbow {"},
        {Kind::SkySphere, {}, "sky_sphere {"},
        {Kind::Texture, {}, object("texture {")},
        {Kind::InteriorTexture, {}, object("interior_texture {")},
        {Kind::Material, {}, object("material {")},
        {Kind::Pigment, {}, pigment("")},
        {Kind::Normal, {}, object("normal {")},
        {Kind::Finish, {}, object("finish {")},
        {Kind::Reflection, Kind::Finish, object("finish { reflection { 0, 1")},
        {Kind::Irid, {}, object("finish { irid { 0.2")},
        {Kind::Subsurface, Kind::Finish, object("finish { subsurface {")},
        {Kind::Interior, {}, object("interior {")},
        {Kind::Media, {}, "media {"},
        {Kind::Scattering, {}, "media { scattering { 1, rgb 1"},
        {Kind::Density, {}, "media { density {"},
        {Kind::ImageMap, {}, pigment("image_map { \"a.png\"")},
        {Kind::BumpMap, {}, object("normal { bump_map { \"a.png\"")},
        {Kind::MaterialMap, {}, object("texture { material_map { \"a.png\"")},
        {Kind::ImagePattern, {}, pigment("image_pattern { \"a.png\"")},
        {Kind::Warp, {}, pigment("granite warp {")},
        {Kind::Photons, {}, object("photons {")},
        {Kind::Photons, Kind::LightSource, "light_source { 0, rgb 1 photons {"},
        {Kind::Photons, Kind::GlobalSettings, "global_settings { photons {"},
        {Kind::Radiosity, {}, object("radiosity {")},
        {Kind::Radiosity, Kind::GlobalSettings, "global_settings { radiosity {"},
        {Kind::Subsurface, Kind::GlobalSettings, "global_settings { subsurface {"},
        {Kind::Transform, {}, object("transform {")},
        {Kind::ClippedBy, {}, object("clipped_by {")},
        {Kind::BoundedBy, {}, object("bounded_by {")},
        {Kind::Sphere, {}, object("")},
        {Kind::Cylinder, {}, "cylinder { 0, y, 1"},
        {Kind::Cone, {}, "cone { 0, 1, y, 0"},
        {Kind::Torus, {}, "torus { 2, 1"},
        {Kind::Union, {}, "union { sphere { 0, 1 }"},
        {Kind::Difference, {}, "difference { sphere { 0, 1 } sphere { x, 1 }"},
        {Kind::Blob, {}, "blob { sphere { 0, 1, 1 }"},
        {Kind::Sphere, Kind::Blob, "blob { sphere { 0, 1, 1"},
        {Kind::Isosurface, {}, "isosurface { function { x }"},
        {Kind::HeightField, {}, "height_field { png \"a.png\""},
        {Kind::Mesh, {}, "mesh { triangle { 0, x, y }"},
    };
    return all;
}

/// Where reading of a text ends; {0, 0}: nowhere before its end.
scene::LineAndColumn stopped_at(const std::string& text)
{
    try {
        parser::parse_text(kHead + text, "t.pov", {});
    } catch (const parser::Error& error) {
        return error.messages().front().place.at;
    }
    return {0, 0};
}

/// Whether the grammar reads on behind a word: what it lacks then stands in the line below.
bool reads(const Spot& spot, std::string_view word)
{
    const scene::LineAndColumn at = stopped_at(fmt::format("{}\n{}\n}}", spot.before, word));
    return !(at.line == 3 && at.column == 1);
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

}  // namespace

TEST_CASE("completion offers the words that the grammar reads", "[places][words]")
{
    const std::vector<std::string> words = all_words();
    REQUIRE(words.size() > 400);
    for (const Spot& spot : spots()) {
        const std::vector<std::string> offered = language::block_words(spot.block, spot.outer);
        std::vector<std::string> refused, untold;
        for (const std::string& word : words) {
            const bool known = std::find(offered.begin(), offered.end(), word) != offered.end();
            const bool taken = reads(spot, word);
            if (known && !taken) refused.push_back(word);
            if (taken && !known) untold.push_back(word);
        }
        INFO(spot.before);
        CHECK(refused == std::vector<std::string>{});
        CHECK(untold == std::vector<std::string>{});
    }
}
