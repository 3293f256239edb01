#include "render/scene/media.h"
#include "render/scene/object.h"

#include <utility>

namespace scene {

void Pattern::transform(const csg::Transform& t)
{
    if (!warps.empty()) {
        if (auto* front = std::get_if<csg::Transform>(&warps.front())) {
            *front = t * *front;
            return;
        }
    }
    warps.insert(warps.begin(), t);
}

void Pigment::transform(const csg::Transform& t)
{
    // A plain colour has no space to move.
    if (auto* patterned = std::get_if<PatternedPigment>(&kind)) patterned->pattern.transform(t);
}

void Normal::transform(const csg::Transform& t) { pattern.transform(t); }

void Texture::transform(const csg::Transform& t)
{
    if (auto* patterned = std::get_if<PatternedTexture>(&kind)) {
        patterned->pattern.transform(t);
        return;
    }
    for (Layer& layer : std::get<std::vector<Layer>>(kind)) {
        layer.pigment.transform(t);
        if (layer.normal) layer.normal->transform(t);
    }
}

namespace {

TexturePtr transformed(const TexturePtr& texture, const csg::Transform& t)
{
    if (!texture) return texture;
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
    if (auto* quadric = std::get_if<Quadric>(&shape)) {
        if (!clipped_by.empty() && !quadric->first_clips) {
            quadric->first_clips =
                std::make_shared<const FirstClips>(FirstClips{clipped_by, transform, quadric->growth});
            quadric->growth = {};
        }
        quadric->growth.add(growth);
    } else if (auto* csg = std::get_if<Csg>(&shape)) {
        csg->growth.add(growth);
    }
    // A light keeps no transformation of its own: items written later must not be moved.
    if (auto* light = std::get_if<Light>(&shape)) transform_light(*light, t);
    else transform = t * transform;

    if (auto* plane = std::get_if<Plane>(&shape); plane != nullptr && !clipped_by.empty()) plane->moved_clips = true;
    // Textures of a uv-mapped object live on its surface (spec 5a, 6).
    if (!flags.uv_mapping) {
        texture = transformed(texture, t);
        interior_texture = transformed(interior_texture, t);
    }
    // The interior of an object that has moved is one of its own, as in POV-Ray; without media there is nothing to
    // move.
    if (interior && !interior->media.empty()) {
        auto moved = std::make_shared<Interior>(*interior);
        moved->transform(t);
        interior = std::move(moved);
    }
    for (Object& clip : clipped_by) clip.transform_by(t, growth);
    for (Object& bound : bounded_by) bound.transform_by(t, growth);
}

}  // namespace scene
