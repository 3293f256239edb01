#include "csg/freeform.h"
#include "csg/solids/cylinder.h"
#include "parser/grammar/shape_makers.h"

namespace parser {
namespace {

using scene::TexturePtr;

/// The component of an item (threshold and the like are none), and the texture written in it.
bool component_of(const scene::StatementItem& item, csg::Blob::Component& out, TexturePtr& texture)
{
    const auto vector = [&](std::size_t k) { return std::get<glm::dvec3>(item.operands[k]); };
    const auto number = [&](std::size_t k) { return number_of(item.operands[k]); };
    std::size_t used = 3;
    if (item.name == "component") {
        out.strength = number(0);
        out.radius = number(1);
        out.frame = csg::Transform::translate(vector(2));
    } else if (item.name == "sphere") {
        out.frame = csg::Transform::translate(vector(0));
        out.radius = number(1);
        out.strength = number(2);
    } else if (item.name == "cylinder") {
        const glm::dvec3 axis = vector(1) - vector(0);
        out.length = glm::length(axis);
        out.frame = csg::axis_frame(vector(0), axis / out.length, 1.0, 1.0);
        out.radius = number(2);
        out.strength = number(3);
        used = 4;
    } else {
        return false;
    }
    for (; used < item.operands.size(); ++used) {
        if (const auto* transform = std::get_if<csg::Transform>(&item.operands[used])) out.frame = *transform * out.frame;
        else texture = std::get<TexturePtr>(item.operands[used]);
    }
    return true;
}

}  // namespace

bool make_blob(SceneBuilder&, const scene::Statement& statement, scene::Object& object)
{
    double threshold = 1.0;
    std::vector<csg::Blob::Component> components;
    std::vector<TexturePtr> textures{nullptr};  // the object's own comes first
    for (const scene::StatementItem& item : statement.items) {
        if (item.name == "threshold") threshold = number_of(item.operands[0]);
        csg::Blob::Component component;
        TexturePtr texture;
        if (!component_of(item, component, texture)) continue;
        std::size_t part = 0;
        while (part < textures.size() && textures[part] != texture) ++part;
        if (part == textures.size()) textures.push_back(texture);
        component.part = static_cast<std::uint32_t>(part);
        components.push_back(component);
    }
    scene::Freeform made{csg::make_freeform<csg::Blob>(threshold, components)};
    if (textures.size() > 1) made.part_textures = std::make_shared<const std::vector<TexturePtr>>(std::move(textures));
    object.shape = std::move(made);
    return true;
}

}  // namespace parser
