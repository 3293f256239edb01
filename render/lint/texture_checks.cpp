#include "render/lint/findings.h"
#include "render/lint/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

namespace lint {
namespace {

constexpr int kDeepestTexture = 100;

bool nobody_wrote(const scene::Pigment& pigment)
{
    const auto* color = std::get_if<scene::Color>(&pigment.kind);
    return color && !pigment.source.somewhere() && color->red == 0 && color->green == 0 && color->blue == 0 &&
           color->filter == 0 && color->transmit == 0;
}

/// Maps of a texture and of what it is made of.
class Maps {
public:
    explicit Maps(Findings& out) : out_(out) {}
    void check(const scene::Texture& texture, const scene::SourceRef& near, int depth = 0)
    {
        if (depth > kDeepestTexture || !seen_.insert(&texture).second) return;
        const scene::SourceRef at = texture.source.somewhere() ? texture.source : near;
        if (const auto* layers = std::get_if<std::vector<scene::Layer>>(&texture.kind)) {
            for (const scene::Layer& layer : *layers) {
                check(layer.pigment, at, depth + 1);
                if (layer.normal) check(*layer.normal, at, depth + 1);
            }
            return;
        }
        const auto& patterned = *std::get<scene::Shared<scene::PatternedTexture>>(texture.kind);
        order(patterned.map, patterned.pattern, "texture_map", at);
        for (const auto& entry : patterned.map)
            if (entry.value) check(*entry.value, at, depth + 1);
    }

private:
    void check(const scene::Pigment& pigment, const scene::SourceRef& near, int depth)
    {
        if (depth > kDeepestTexture) return;
        const auto* shared = std::get_if<scene::Shared<scene::PatternedPigment>>(&pigment.kind);
        if (!shared || !seen_.insert(&**shared).second) return;
        const scene::SourceRef at = pigment.source.somewhere() ? pigment.source : near;
        const scene::PatternedPigment& patterned = **shared;
        if (const auto* colors = std::get_if<scene::ColorMap>(&patterned.map))
            return order(*colors, patterned.pattern, "color_map", at);
        const auto& pigments = std::get<scene::PigmentMap>(patterned.map);
        order(pigments, patterned.pattern, "pigment_map", at);
        for (const auto& entry : pigments)
            if (entry.value) check(*entry.value, at, depth + 1);
    }
    void check(const scene::Normal& normal, const scene::SourceRef& near, int depth)
    {
        if (depth > kDeepestTexture || !seen_.insert(&normal).second) return;
        const scene::SourceRef at = normal.source.somewhere() ? normal.source : near;
        if (const auto* slopes = std::get_if<std::vector<scene::MapEntry<glm::dvec2>>>(&normal.map))
            return order(*slopes, normal.pattern, "slope_map", at);
        const auto* normals = std::get_if<std::vector<scene::MapEntry<scene::NormalPtr>>>(&normal.map);
        if (!normals) return;
        order(*normals, normal.pattern, "normal_map", at);
        for (const auto& entry : *normals)
            if (entry.value) check(*entry.value, at, depth + 1);
    }
    /// Keys of `average` are weights: any order is as good.
    template <class Map>
    void order(const Map& map, const scene::Pattern& pattern, const char* what, const scene::SourceRef& at)
    {
        if (pattern.name == "average") return;
        for (std::size_t i = 1; i < map.size(); ++i)
            if (map[i].key < map[i - 1].key)
                return out_.add("map-order", pattern.source.somewhere() ? pattern.source : at,
                                fmt::format("entry {} of the {} has the key {:g}, less than {:g} before it", i + 1,
                                            what, map[i].key, map[i - 1].key));
    }
    Findings& out_;
    std::unordered_set<const void*> seen_;
};

bool bears_texture(const scene::Object& object)
{
    return !scene::is_light(object) && !std::holds_alternative<scene::Csg>(object.shape);
}

}  // namespace

void check_textures(Findings& out, const scene::Description& description)
{
    Maps maps(out);
    walk(description, [&](const Visited& at) {
        if (at.object.texture) maps.check(*at.object.texture, at.object.source);
        if (!bears_texture(at.object) || at.object.flags.no_image || at.takes_cut_texture) return;
        const scene::TexturePtr& usual = description.default_of(at.top);
        const scene::Texture* texture = at.texture ? at.texture : usual.get();
        if (!texture) return;
        // Faces and parts may have textures of their own.
        const auto* mesh = std::get_if<scene::Mesh>(&at.object.shape);
        if (mesh && mesh->data && !mesh->data->textures.empty()) return;
        if (const auto* freeform = std::get_if<scene::Freeform>(&at.object.shape))
            if (freeform->part_textures && !freeform->part_textures->empty()) return;
        const auto* layers = std::get_if<std::vector<scene::Layer>>(&texture->kind);
        if (!layers || layers->empty() || !nobody_wrote(layers->front().pigment)) return;
        out.add("no-pigment", at.object.source, fmt::format("this {} has no pigment: it is black", name_of(at.object)));
    });
}

}  // namespace lint
