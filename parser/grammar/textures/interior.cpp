#include "parser/grammar/scene/effects.h"
#include "parser/grammar/core/rules.h"

namespace parser {
namespace {

struct InteriorState : BlockState {
    using BlockState::BlockState;
    scene::Interior interior;
};
struct ior : item<Kind::Ior, a_number> {
    static void act(InteriorState& s) { s.interior.ior = s.pop_single(); }
};
struct dispersion : item<Kind::Dispersion, a_number> {
    static void act(InteriorState& s) { s.interior.dispersion = s.pop_single(); }
};
struct dispersion_samples : item<Kind::DispersionSamples, a_number> {
    static void act(InteriorState& s)
    {
        s.interior.dispersion_samples = s.pop_int();
        if (s.interior.dispersion_samples < 2)
            s.stream().fail(s.stream().last(), "dispersion_samples must be at least 2");
    }
};
struct caustics : item<Kind::Caustics, a_number> {
    static void act(InteriorState& s) { s.interior.caustics = s.pop_single(); }
};
struct fade_distance : item<Kind::FadeDistance, a_number> {
    static void act(InteriorState& s) { s.interior.fade_distance = s.pop_single(); }
};
struct fade_power : item<Kind::FadePower, a_number> {
    static void act(InteriorState& s) { s.interior.fade_power = s.pop_single(); }
};
struct fade_color : item<Kind::FadeColor> {
    static void act(InteriorState& s) { s.interior.fade_color = parser::rgb_expr(s.stream()).rgb(); }
};
struct refraction : item<Kind::Refraction, a_number> {
    static void act(InteriorState& s) { s.interior.refraction = s.pop_single(); }
};
struct media : item<Kind::Media> {
    static void act(InteriorState& s)
    {
        s.interior.media.push_back(std::make_shared<const scene::Media>(read_media(s.build)));
    }
};
struct InteriorItems {
    static bool match(SceneBuilder& build, InteriorState& s)
    {
        using Items = table<InteriorState, ior, dispersion, dispersion_samples, caustics, fade_distance, fade_power,
                            fade_color, refraction, media>;
        if (Items::match(build, s)) return true;
        const auto transform = read_transformation(build);
        if (transform) s.interior.transform(*transform);  // the media that stand before it
        return transform.has_value();
    }
};

struct MaterialState : BlockState {
    using BlockState::BlockState;
    Material material;
};
struct texture : item<Kind::Texture> {
    static void act(MaterialState& s)
    {
        const scene::SourceRef at = s.stream().last();
        s.material.texture = layered(s.build, s.material.texture, read_texture(s.build), at);
    }
};
struct interior_texture : item<Kind::InteriorTexture> {
    static void act(MaterialState& s)
    {
        const scene::SourceRef at = s.stream().last();
        s.material.interior_texture = layered(s.build, s.material.interior_texture, read_texture(s.build), at);
    }
};
struct interior : item<Kind::Interior> {
    static void act(MaterialState& s)
    {
        const scene::Interior base = s.material.interior ? *s.material.interior : scene::Interior{};
        s.material.interior = std::make_shared<scene::Interior>(read_interior(s.build, base));
    }
};

/// Moves the textures present, not the interior texture (spec 3, 15.7).
bool transform_material(MaterialState& s)
{
    const auto t = read_transformation(s.build);
    if (!t) return false;
    if (s.material.texture) {
        auto moved = std::make_shared<scene::Texture>(*s.material.texture);
        moved->transform_in_text(*t);
        s.material.texture = std::move(moved);
    }
    return true;
}

}  // namespace

scene::Interior read_interior(SceneBuilder& build, const scene::Interior& base)
{
    InteriorState s(build);
    s.interior = base;
    const scene::SourceRef source = build.stream().last();
    read_block<InteriorItems>(build, s, "interior", [&] {
        if (const auto declared = build.stream().accept_identifier<std::shared_ptr<const scene::Interior>>())
            s.interior = **declared;
    });
    s.interior.source = source;
    return s.interior;
}

Material read_material(SceneBuilder& build, Material current)
{
    MaterialState s(build);
    s.material = std::move(current);
    const scene::SourceRef opened = build.open_block("material");
    if (const auto declared = build.stream().accept_identifier<std::shared_ptr<const Material>>()) {
        const Material& other = **declared;
        if (other.texture) s.material.texture = layered(build, s.material.texture, other.texture, opened);
        if (other.interior_texture)
            s.material.interior_texture = layered(build, s.material.interior_texture, other.interior_texture, opened);
        // A copy of its own: interiors are told apart by identity.
        s.material.interior = other.interior ? std::make_shared<scene::Interior>(*other.interior) : nullptr;
    }
    while (table<MaterialState, texture, interior_texture, interior>::match(build, s) || transform_material(s)) {}
    build.close_block("material", opened);
    return s.material;
}

}  // namespace parser
