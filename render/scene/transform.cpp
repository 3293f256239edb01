#include "render/scene/inside.h"
#include "render/scene/media.h"
#include "render/scene/object.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace scene {

void Pattern::transform(const csg::Transform& t)
{
    auto* const before = warps.empty() ? nullptr : std::get_if<csg::Transform>(&warps.back());
    if (before != nullptr) *before = t * *before;
    else warps.push_back(t);
}

void Pigment::transform(const csg::Transform& t)
{
    // A plain colour has no space to move.
    if (auto* patterned = std::get_if<Shared<PatternedPigment>>(&kind)) patterned->edit().pattern.transform(t);
}

void Pigment::move_space(const csg::Transform& t)
{
    if (std::holds_alternative<Color>(kind) && !t.identity()) space.edit().pattern.transform(t);
}

void Normal::transform(const csg::Transform& t) { pattern.transform(t); }

void Texture::transform(const csg::Transform& t)
{
    if (auto* patterned = std::get_if<Shared<PatternedTexture>>(&kind)) {
        patterned->edit().pattern.transform(t);
        return;
    }
    for (Layer& layer : std::get<std::vector<Layer>>(kind)) {
        layer.pigment.transform(t);
        if (layer.normal) {
            auto moved = std::make_shared<Normal>(*layer.normal);
            moved->transform(t);
            layer.normal = std::move(moved);
        }
    }
}

void Texture::transform_in_text(const csg::Transform& t)
{
    transform(t);
    if (auto* layers = std::get_if<std::vector<Layer>>(&kind))
        for (Layer& layer : *layers) layer.pigment.move_space(t);
}

bool Texture::alike_everywhere() const
{
    const auto* layers = std::get_if<std::vector<Layer>>(&kind);
    return layers != nullptr && std::all_of(layers->begin(), layers->end(), [](const Layer& layer) {
               return std::holds_alternative<Color>(layer.pigment.kind) && !layer.normal;
           });
}

namespace {

TexturePtr transformed(const TexturePtr& texture, const csg::Transform& t)
{
    if (!texture || texture->alike_everywhere()) return texture;
    auto copy = std::make_shared<Texture>(*texture);
    copy->transform(t);
    return copy;
}

std::shared_ptr<const Object> transformed(const std::shared_ptr<const Object>& object, const csg::Transform& t)
{
    if (!object) return object;
    auto copy = std::make_shared<Object>(*object);
    copy->transform_by(t);
    return copy;
}

void transform_light(Light& light, const csg::Transform& t)
{
    light.location = t.point(light.location);
    light.point_at = t.point(light.point_at);
    light.axis1 = t.vector(light.axis1);
    light.axis2 = t.vector(light.axis2);
    light.looks_like = transformed(light.looks_like, t);
    light.projected_through = transformed(light.projected_through, t);
}

/// What is moved with an object beside its shape and texture.
void transform_details(ObjectDetails& details, const csg::Transform& t, const BoxGrowth& growth, bool textures)
{
    if (textures) details.interior_texture = transformed(details.interior_texture, t);
    if (details.interior && !details.interior->media.empty()) {
        auto moved = std::make_shared<Interior>(*details.interior);
        moved->transform(t);
        details.interior = std::move(moved);
    }
    for (Object& clip : details.clipped_by) clip.transform_by(t, growth);
    for (Object& bound : details.bounded_by) bound.transform_by(t, growth);
}

/// Whether t * Transform{} is t to the last bit: all products with 1 and sums with products of 0 give the number itself
/// where it is finite and not -0.
bool settled(const csg::Transform& t)
{
    constexpr std::uint64_t kExponent = 0x7ff0000000000000, kMinusZero = 0x8000000000000000;
    bool unsettled = false;
    for (const std::uint64_t bits :
         std::bit_cast<std::array<std::uint64_t, sizeof(csg::Transform) / sizeof(double)>>(t))
        unsettled |= (bits & kExponent) == kExponent || bits == kMinusZero;
    return !unsettled;
}

}  // namespace

Media Media::of_version(int version)
{
    constexpr int kAdaptiveSince = 350;
    Media media;
    if (version >= kAdaptiveSince) return media;
    media.method = Method::Random;
    media.intervals = 10;
    media.samples_least = media.samples_most = 1;
    return media;
}

void Media::transform(const csg::Transform& t)
{
    for (Pigment& density : densities) density.transform(t);
}

void Interior::transform(const csg::Transform& t)
{
    for (std::shared_ptr<const Media>& one : media) {
        auto moved = std::make_shared<Media>(*one);
        moved->transform(t);
        one = std::move(moved);
    }
}

void Object::transform_by(const csg::Transform& t, const BoxGrowth& growth)
{
    if (forgets_inverse) forget_inverse(*this);
    const bool grows = growth.edges != glm::dmat3(1.0);
    const bool clipped = !details->clipped_by.empty();
    if (auto* quadric = std::get_if<Shared<Quadric>>(&shape)) {
        QuadricPast& past = quadric->edit().past.edit();
        if (clipped && !past.first_clips) {
            past.first_clips =
                std::make_shared<const FirstClips>(FirstClips{details->clipped_by, *transform, past.growth});
            past.growth = {};
        }
        if (grows) past.growth.add(growth);
    } else if (auto* csg = std::get_if<Csg>(&shape)) {
        if (grows) csg->growth.edit().add(growth);
    }
    // A light keeps no transformation of its own: items written later must not be moved.
    if (auto* light = std::get_if<Shared<Light>>(&shape)) transform_light(light->edit(), t);
    else if (transform.given()) transform.edit() = t * *transform;
    else transform = settled(t) ? t : t * *transform;

    if (auto* plane = std::get_if<Plane>(&shape); plane != nullptr && clipped) plane->moved_clips = true;
    // Textures of a uv-mapped object live on its surface (spec 5a, 6).
    if (!flags.uv_mapping) texture = transformed(texture, t);
    if (details.given()) transform_details(details.edit(), t, growth, !flags.uv_mapping);
}

}  // namespace scene
