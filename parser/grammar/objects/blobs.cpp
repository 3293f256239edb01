#include "csg/freeform/freeform.h"
#include "csg/solids/cylinder.h"
#include "parser/grammar/core/solid_reader.h"

#include <unordered_map>

/// Components whose strengths add up (reference manual: Blob).
namespace parser {
namespace {

using Component = scene::Blob::Component;
using scene::TexturePtr;

struct ComponentState : BlockState {
    ComponentState(SceneBuilder& b, Component::Kind kind) : BlockState(b) { component.kind = kind; }
    Component& subject() { return component; }
    Component component;
};
struct cylinder_ends : values<&Component::center, &Component::end, &Component::radius>, item_base {
    static void act(ComponentState& s)
    {
        constexpr double kShortest = 1e-10;  // POV-Ray's (spec 5a, 5.11)
        if (glm::distance(s.component.center, s.component.end) < kShortest)
            s.fail("the two ends of this cylinder are one point");
    }
};
/// What moves and colours it.
struct ComponentItems {
    static bool match(SceneBuilder&, ComponentState& s)
    {
        scene::Object modified;
        read_component_modifiers(s.build, modified);
        s.component.transform = modified.transform;
        s.component.texture = modified.texture;
        return false;
    }
    static std::vector<Kind> words() { return {}; }
    static Form form() { return Form::named(component_modifier); }
};
struct strength : seq<opt_comma, opt<token<Kind::Strength>>, values<&Component::strength>>, always {};
using SphereBlock = block<Kind::Sphere, ComponentItems, values<&Component::center, &Component::radius>, strength>;
using CylinderBlock = block<Kind::Cylinder, ComponentItems, cylinder_ends, strength>;
using plain_component = values<&Component::strength, &Component::radius, &Component::center>;

using BlobState = ParameterState<scene::Blob>;
template <Kind kind, Component::Kind shape, class Inside>
struct component : item<kind, by_action<Inside>> {
    static void act(BlobState& s)
    {
        ComponentState inner(s.build, shape);
        if constexpr (requires { Inside::read(s.build, inner); }) Inside::read(s.build, inner);
        else read_rule<Inside>(s.build, inner);
        s.solid.components.push_back(std::move(inner.component));
    }
};
using BlobItems = table<BlobState, member<Kind::Threshold, &scene::Blob::threshold>, ignored<Kind::Sturm>,
                        ignored<Kind::Hierarchy>, component<Kind::Sphere, Component::Kind::Sphere, SphereBlock>,
                        component<Kind::Cylinder, Component::Kind::Cylinder, CylinderBlock>,
                        component<Kind::Component, Component::Kind::Plain, plain_component>>;

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

Form parameters_form(const SolidReader*, const scene::Blob*, Kind) { return Form::repeated(BlobItems::form()); }

bool read_parameters(SolidReader& s, scene::Blob& blob)
{
    ComponentReceiver receiver(blob);
    BlobState state(s, blob);
    do peek_for(s.in(), s.build.receiver, receiver);
    while (BlobItems::match(s.build, state));
    if (blob.components.empty()) s.build.fail_unknown("a component of the blob: sphere or cylinder");
    s.object().shape = shape_of(s.written, blob);
    return true;
}

}  // namespace parser
