#include "render/plan/textures/pattern_kinds.h"
#include "render/plan/textures/textures.h"

#include <utility>

/// Textures that stand at many places: all but the first are copies of what was made for the first, with other warps.
namespace plan {
namespace {

template <class T>
std::uint32_t added(std::vector<T>& all, const T& one)
{
    all.push_back(one);
    return static_cast<std::uint32_t>(all.size() - 1);
}

}  // namespace

std::uint32_t TextureCompiler::pattern_again(std::uint32_t known, const scene::Pattern& description,
                                             const csg::Transform& by)
{
    texture::Pattern pattern = out_.patterns[known];
    compile_warps(description, &by, pattern, out_.warps);
    return added(out_.patterns, pattern);
}

std::uint32_t TextureCompiler::again(std::uint32_t known, const scene::Texture& description, const csg::Transform& by)
{
    texture::Texture out = out_.textures[known];
    if (const auto* patterned = std::get_if<scene::Shared<scene::PatternedTexture>>(&description.kind)) {
        out.pattern = pattern_again(out.pattern, (*patterned)->pattern, by);
        return added(out_.textures, out);
    }
    const auto& layers = std::get<std::vector<scene::Layer>>(description.kind);
    const std::uint32_t first = std::exchange(out.first, static_cast<std::uint32_t>(out_.layers.size()));
    bool judged_anew = false;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        texture::Layer layer = out_.layers[first + i];
        texture::Pigment pigment = out_.pigments[layer.pigment];
        if (pigment.pattern != texture::kNone) {
            const auto& written = *std::get<scene::Shared<scene::PatternedPigment>>(layers[i].pigment.kind);
            judged_anew |= std::holds_alternative<scene::PigmentMap>(written.map);
            pigment.pattern = pattern_again(pigment.pattern, written.pattern, by);
            opaque_pigments_.push_back(opaque_pigments_[layer.pigment]);
            layer.pigment = added(out_.pigments, pigment);
        }
        if (layer.normal != texture::kNone) {
            texture::Normal normal = out_.normals[layer.normal];
            normal.pattern = pattern_again(normal.pattern, layers[i].normal->pattern, by);
            layer.normal = added(out_.normals, normal);
        }
        out_.layers.push_back(layer);
    }
    if (judged_anew) {  // of pictures in maps something else is found from the second time on (shadow_opacity.cpp)
        bool stops = out.opaque;
        for (const scene::Layer& layer : layers) stops |= !lets_light_through(layer.pigment);
        out.stops_light = stops;
    }
    return added(out_.textures, out);
}

}  // namespace plan
