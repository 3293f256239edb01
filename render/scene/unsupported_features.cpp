#include "render/scene/unsupported_features.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <unordered_set>

namespace scene {
namespace {

class Finder {
public:
    std::vector<Unsupported> found;

    void tell(const std::string& what, const SourceRef& source)
    {
        if (told_.insert(what).second) found.push_back({what, source});
    }
    void object(const Object& object)
    {
        texture(object.texture);
        texture(object.interior_texture);
        if (const auto* csg = std::get_if<Csg>(&object.shape)) operands(csg->operands);
        if (const auto* light = std::get_if<Light>(&object.shape); light && light->looks_like)
            this->object(*light->looks_like);
        if (const auto* mesh = std::get_if<Mesh>(&object.shape);
            mesh && mesh->data && seen_.insert(mesh->data.get()).second)
            for (const TexturePtr& face : mesh->data->textures) texture(face);
        if (const auto* freeform = std::get_if<Freeform>(&object.shape); freeform && freeform->part_textures)
            for (const TexturePtr& part : *freeform->part_textures) texture(part);
    }
    void texture(const TexturePtr& texture)
    {
        if (!texture || !seen_.insert(texture.get()).second) return;
        if (const auto* patterned = std::get_if<PatternedTexture>(&texture->kind)) {
            for (const MapEntry<TexturePtr>& entry : patterned->map) this->texture(entry.value);
            return;
        }
        const auto& layers = std::get<std::vector<Layer>>(texture->kind);
        for (const Layer& layer : layers)
            if (layer.finish.subsurface) tell("subsurface", layer.finish.subsurface->source);
    }

private:
    void operands(const std::shared_ptr<const std::vector<Object>>& all)
    {
        if (!all || !seen_.insert(all.get()).second) return;
        for (const Object& operand : *all) object(operand);
    }
    std::set<std::string> told_;
    std::unordered_set<const void*> seen_;  // what copies of a declared object share
};

/// Blocks that are not an object's: settings, what fills space, the camera; each group in the order of the text.
/// `subsurface` of global_settings changes nothing by itself.
std::vector<Unsupported> of_whole_scene(const Description& description)
{
    const GlobalSettings& global = description.global;
    std::vector<Unsupported> settings, space, all;
    if (global.photons) settings.push_back({"photons", global.photons->source});
    for (std::vector<Unsupported>* group : {&settings, &space}) {
        std::stable_sort(group->begin(), group->end(), [](const Unsupported& a, const Unsupported& b) {
            return std::tie(a.source.file, a.source.line, a.source.column) <
                   std::tie(b.source.file, b.source.line, b.source.column);
        });
        all.insert(all.end(), group->begin(), group->end());
    }
    return all;
}

}  // namespace

std::vector<Unsupported> unsupported_features(const Description& description, bool in_objects)
{
    Finder finder;
    for (const Unsupported& asked : of_whole_scene(description)) finder.tell(asked.what, asked.source);
    for (const Object& object : description.unsupported_objects) finder.tell(object.unsupported, object.source);
    if (!in_objects) return finder.found;
    for (const Object& object : description.objects) {
        finder.object(object);
        finder.texture(object.default_texture);
    }
    return finder.found;
}

}  // namespace scene
