#include "parser/grammar/scene/effects.h"
#include "parser/grammar/core/rules.h"

namespace parser {
namespace {

struct InteriorState : BlockState {
    using BlockState::BlockState;
    scene::Interior& subject() { return interior; }
    void take(const std::shared_ptr<const scene::Interior>& declared) { interior = *declared; }
    void move(const csg::Transform& by) { interior.transform(by); }  // the media that stand before it
    scene::Interior interior;
};
struct dispersion_samples : item<Kind::DispersionSamples, a_number> {
    static void act(InteriorState& s)
    {
        s.interior.dispersion_samples = s.pop_int();
        if (s.interior.dispersion_samples < 2) s.fail("dispersion_samples must be at least 2");
    }
};
struct media : item<Kind::Media, reads<media_block>> {
    static void act(InteriorState& s)
    {
        s.interior.media.push_back(std::make_shared<const scene::Media>(read_media(s.build)));
    }
};
using scene::Interior;
struct old_refraction : member<Kind::Refraction, &Interior::refraction> {
    static constexpr bool rare = true;
};
using InteriorItems =
    either<table<InteriorState, dispersion_samples, media, old_refraction, member<Kind::Ior, &Interior::ior>,
                 member<Kind::Dispersion, &Interior::dispersion>, member<Kind::Caustics, &Interior::caustics>,
                 member<Kind::FadeDistance, &Interior::fade_distance>, member<Kind::FadePower, &Interior::fade_power>,
                 member<Kind::FadeColor, &Interior::fade_color>>,
           moves>;
using InteriorBlock = block<Kind::Interior, InteriorItems, opt<declared<std::shared_ptr<const Interior>>>>;

struct MaterialState : BlockState {
    using BlockState::BlockState;
    Material material;
    void take(const std::shared_ptr<const Material>& declared)
    {
        const scene::SourceRef opened = stream().last();
        if (declared->texture)
            material.texture = layered(build, std::move(material.texture), declared->texture, opened);
        if (declared->interior_texture)
            material.interior_texture =
                layered(build, std::move(material.interior_texture), declared->interior_texture, opened);
        // A copy of its own: interiors are told apart by identity.
        material.interior = declared->interior ? std::make_shared<scene::Interior>(*declared->interior) : nullptr;
    }
    /// Moves the textures present, not the interior texture (spec 3, 15.7).
    void move(const csg::Transform& by)
    {
        if (!material.texture) return;
        auto moved = std::make_shared<scene::Texture>(*material.texture);
        moved->transform_in_text(by);
        material.texture = std::move(moved);
    }
};
struct texture : item<Kind::Texture, reads<texture_block>> {
    static void act(MaterialState& s)
    {
        const scene::SourceRef at = s.stream().last();
        s.material.texture = layered(s.build, std::move(s.material.texture), read_texture(s.build), at);
    }
};
struct interior_texture : item<Kind::InteriorTexture, reads<texture_block>> {
    static void act(MaterialState& s)
    {
        const scene::SourceRef at = s.stream().last();
        s.material.interior_texture =
            layered(s.build, std::move(s.material.interior_texture), read_texture(s.build), at);
    }
};
struct interior : item<Kind::Interior, reads<interior_block>> {
    static void act(MaterialState& s)
    {
        const scene::Interior base = s.material.interior ? *s.material.interior : scene::Interior{};
        s.material.interior = std::make_shared<scene::Interior>(read_interior(s.build, base));
    }
};

using MaterialItems = either<table<MaterialState, texture, interior_texture, interior>, moves>;
using MaterialBlock = block<Kind::Material, MaterialItems, opt<declared<std::shared_ptr<const Material>>>>;

}  // namespace

Production interior_block() { return {"interior_block", InteriorBlock::form()}; }
Production material_block() { return {"material_block", MaterialBlock::form()}; }

Interior read_interior(SceneBuilder& build, const Interior& base)
{
    InteriorState s(build);
    s.interior = base;
    const scene::SourceRef source = build.stream().last();
    InteriorBlock::read(build, s);
    s.interior.source = source;
    return s.interior;
}

Material read_material(SceneBuilder& build, Material current)
{
    MaterialState s(build);
    s.material = std::move(current);
    MaterialBlock::read(build, s);
    return s.material;
}

}  // namespace parser
