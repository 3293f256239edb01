#include "csg/freeform/freeform.h"
#include "csg/solids/cylinder.h"
#include "parser/grammar/core/solid_reader.h"

#include <unordered_map>

/// Components whose strengths add up (reference manual: Blob).
namespace parser {
namespace {

using Component = scene::Blob::Component;
using scene::TexturePtr;

void read_sphere_or_cylinder(SolidReader& s, Component& c)
{
    const bool is_sphere = c.kind == Component::Kind::Sphere;
    const char* name = is_sphere ? "sphere" : "cylinder";
    const auto opened = s.build().open_block(name);
    if (is_sphere) read_values(s.in(), c.center, c.radius);
    else read_values(s.in(), c.center, c.end, c.radius);
    constexpr double kShortest = 1e-10;  // POV-Ray's (spec 5a, 5.11)
    if (!is_sphere && glm::distance(c.center, c.end) < kShortest) s.fail("the two ends of this cylinder are one point");
    s.in().accept_comma();
    s.accept(Kind::Strength);
    c.strength = float_expr(s.in());
    scene::Object modified;
    read_component_modifiers(s.build(), modified);
    c.transform = modified.transform;
    c.texture = modified.texture;
    s.build().close_block(name, opened);
}

bool read_component(SolidReader& s, scene::Blob& blob)
{
    Component c;
    if (s.accept(Kind::Component)) {
        c.kind = Component::Kind::Plain;
        read_values(s.in(), c.strength, c.radius, c.center);
    } else {
        if (s.accept(Kind::Cylinder)) c.kind = Component::Kind::Cylinder;
        else if (!s.accept(Kind::Sphere)) return false;
        read_sphere_or_cylinder(s, c);
    }
    blob.components.push_back(std::move(c));
    return true;
}

csg::Blob::Component shape_of(const Component& c)
{
    csg::Blob::Component out;
    out.strength = c.strength;
    out.radius = c.radius;
    if (c.kind == Component::Kind::Cylinder) {
        const glm::dvec3 axis = c.end - c.center;
        out.length = glm::length(axis);
        out.frame = csg::axis_frame(c.center, axis / out.length, 1.0, 1.0);
    } else {
        out.frame = csg::Transform::translate(c.center);
    }
    if (!c.transform->identity()) out.frame = *c.transform * out.frame;
    return out;
}

/// `parts`: which of the textures each component has.
csg::Blob made_of(const scene::Blob& blob, const std::vector<std::uint32_t>& parts)
{
    std::vector<csg::Blob::Component> components;
    components.reserve(blob.components.size());
    for (std::size_t i = 0; i < blob.components.size(); ++i)
        components.emplace_back(shape_of(blob.components[i])).part = parts[i];
    return csg::Blob(blob.threshold, components);
}

/// The blob itself is made when it is asked for: most files that are read ask for nothing before the picture is
/// planned.
scene::Freeform shape_of(std::shared_ptr<const scene::WrittenSolid> written, const scene::Blob& blob)
{
    std::vector<TexturePtr> textures{nullptr};  // the object's own comes first
    std::unordered_map<const scene::Texture*, std::uint32_t> known{{nullptr, 0}};
    std::vector<std::uint32_t> parts;
    parts.reserve(blob.components.size());
    for (const Component& component : blob.components) {
        const auto [part, fresh] =
            known.try_emplace(component.texture.get(), static_cast<std::uint32_t>(textures.size()));
        if (fresh) textures.push_back(component.texture);
        parts.push_back(part->second);
    }
    const auto make = [kept = std::move(written), &blob, parts = std::move(parts)] { return made_of(blob, parts); };
    scene::Freeform made{csg::make_freeform_later(csg::Blob(blob.threshold, {}), make)};
    if (textures.size() > 1) made.part_textures = std::make_shared<const std::vector<TexturePtr>>(std::move(textures));
    return made;
}

}  // namespace

bool read_parameters(SolidReader& s, scene::Blob& blob)
{
    ComponentReceiver receiver(blob);
    for (;;) {
        peek_for(s.in(), s.build().receiver, receiver);
        if (read_one(s, blob, std::tuple(field(Kind::Threshold, &scene::Blob::threshold)))) continue;
        if (s.accept(Kind::Sturm) || s.accept(Kind::Hierarchy)) optional_flag(s.in());
        else if (!read_component(s, blob)) break;
    }
    if (blob.components.empty()) s.build().fail_unknown("a component of the blob: sphere or cylinder");
    s.object().shape = shape_of(s.written, blob);
    return true;
}

}  // namespace parser
