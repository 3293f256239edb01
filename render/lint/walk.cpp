#include "render/lint/walk.h"

#include "render/scene/solids.h"

#include <algorithm>
#include <unordered_set>

namespace lint {
namespace {

constexpr std::size_t kMostVisited = 500'000;
constexpr int kDeepest = 400;

struct Walk {
    const std::function<void(const Visited&)>& visit;
    std::size_t left = kMostVisited;
    std::unordered_set<const void*> lists;  ///< of operands, seen

    void go(const scene::Object& object, const scene::Object& top, const csg::Transform& parent,
            const scene::Texture* texture, int depth, bool cutaway = false)
    {
        if (left == 0 || depth > kDeepest) return;
        --left;
        if (object.texture) texture = object.texture.get();
        visit({object, top, parent, texture, cutaway});
        const auto* csg = std::get_if<scene::Csg>(&object.shape);
        if (!csg || !csg->operands || !lists.insert(csg->operands.get()).second) return;
        const csg::Transform here = parent * *object.transform;
        for (const scene::Object& operand : *csg->operands)
            go(operand, top, here, texture, depth + 1, cutaway || csg->cutaway_textures);
    }
};

/// Calls for each layer of a texture and of those that it is made of. True as soon as `found` says so.
bool any_layer(const scene::Texture& texture, const std::function<bool(const scene::Layer&)>& found, int depth = 0)
{
    if (depth > kDeepest) return false;
    if (const auto* layers = std::get_if<std::vector<scene::Layer>>(&texture.kind))
        return std::any_of(layers->begin(), layers->end(), found);
    const auto& map = std::get<scene::Shared<scene::PatternedTexture>>(texture.kind)->map;
    return std::any_of(map.begin(), map.end(),
                       [&](const auto& entry) { return entry.value && any_layer(*entry.value, found, depth + 1); });
}

bool clear(const scene::Color& c) { return c.filter > 0 || c.transmit > 0; }

bool clear_pigment(const scene::Pigment& pigment, int depth = 0)
{
    if (depth > kDeepest) return false;
    if (const auto* color = std::get_if<scene::Color>(&pigment.kind)) return clear(*color);
    const scene::PatternedPigment& patterned = *std::get<scene::Shared<scene::PatternedPigment>>(pigment.kind);
    if (const auto* colors = std::get_if<scene::ColorMap>(&patterned.map))
        return colors->empty() ||  // a picture may have holes
               std::any_of(colors->begin(), colors->end(), [](const auto& e) { return clear(e.value); });
    const auto& pigments = std::get<scene::PigmentMap>(patterned.map);
    return std::any_of(pigments.begin(), pigments.end(),
                       [&](const auto& e) { return e.value && clear_pigment(*e.value, depth + 1); });
}

}  // namespace

void walk(const scene::Description& description, const std::function<void(const Visited&)>& visit)
{
    Walk walk{visit, kMostVisited, {}};
    const csg::Transform world;
    for (const scene::Object& object : description.objects) walk.go(object, object, world, nullptr, 0);
}

bool lets_light_through(const scene::Texture& texture)
{
    return any_layer(texture, [](const scene::Layer& layer) { return clear_pigment(layer.pigment); });
}

bool glows(const scene::Texture& texture)
{
    return any_layer(texture, [](const scene::Layer& layer) {
        constexpr float kSeen = 0.3f;
        const scene::Finish& f = *layer.finish;
        return f.emission != glm::vec3(0) || f.ambient.x > kSeen || f.ambient.y > kSeen || f.ambient.z > kSeen;
    });
}

std::string_view name_of(const scene::Object& object)
{
    if (object.details->written) return object.details->written->keyword;
    if (const auto* csg = std::get_if<scene::Csg>(&object.shape)) {
        static constexpr std::string_view kOps[] = {"union", "intersection", "difference", "merge"};
        return kOps[static_cast<std::size_t>(csg->op)];
    }
    static constexpr std::string_view kShapes[] = {
        "sphere",          "box",  "plane", "cylinder",   "cone",   "torus",  "quadric",     "disc", "triangle",
        "smooth_triangle", "mesh", "prism", "polynomial", "object", "object", "light_source"};
    static_assert(std::size(kShapes) == std::variant_size_v<scene::ShapeKinds::variant>);
    return kShapes[object.shape.index()];
}

}  // namespace lint
