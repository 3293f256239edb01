#include "parser/grammar/ready/recipe.h"
#include "render/scene/last_bits.h"

namespace parser {
namespace {

using SharedObject = std::shared_ptr<const scene::Object>;

/// A declared object that is drawn.
const scene::Object* declared_object(const Making& m, std::uint32_t name)
{
    const auto* const declared = m.meaning<SharedObject>(name);
    return declared && (*declared)->drawn() ? declared->get() : nullptr;
}

/// read_transformation() puts each together with none; what that product rounds to is known of the plain ones.
csg::Transform moved_by(const glm::dvec3& by)
{
    const glm::dvec3 there = by + 0.0, back = -by + 0.0;  // no -0
    csg::Transform made;
    made.offset = there;
    made.inverse_offset = back;
    return there - there == glm::dvec3(0.0) ? made : csg::Transform::translate(by) * csg::Transform{};
}
csg::Transform scaled_by(const glm::dvec3& by)
{
    const csg::Transform made = csg::Transform::scale(by);
    const glm::dvec3 back(made.inverse_linear[0][0], made.inverse_linear[1][1], made.inverse_linear[2][2]);
    return by - by == glm::dvec3(0.0) && back - back == glm::dvec3(0.0) ? made : made * csg::Transform{};
}

}  // namespace

bool ModifierRecipe::apply(const Making& m, scene::Object& object) const
{
    const csg::Transform none;
    switch (keyword) {
    case Kind::Translate: object.transform_by(moved_by(m.vector(value))); return true;
    case Kind::Rotate:
        object.transform_by(scene::rotation(m.vector(value), m.build.stream().povray()) * none);
        return true;
    case Kind::Scale: {
        const glm::dvec3 by = m.vector(value);
        if (by.x == 0.0 || by.y == 0.0 || by.z == 0.0) return false;
        object.transform_by(scaled_by(by));
        return true;
    }
    case Kind::Transform: {
        const auto* const declared = m.meaning<std::shared_ptr<const csg::Transform>>(name);
        if (!declared) return false;
        object.transform_by(**declared * none);
        return true;
    }
    case Kind::NoShadow: object.flags.no_shadow = true; return true;
    case Kind::NoImage: object.flags.no_image = true; return true;
    case Kind::NoReflection: object.flags.no_reflection = true; return true;
    case Kind::Hollow: object.flags.hollow = true; return true;
    default: return change->apply(m, object.texture);
    }
}

bool apply_modifiers(const std::vector<ModifierRecipe>& modifiers, const Making& m, scene::Object& object)
{
    for (const ModifierRecipe& one : modifiers)
        if (!one.apply(m, object)) return false;
    return true;
}

bool ObjectRecipe::make_operands(const Making& m, scene::Object& object) const
{
    const auto all = std::make_shared<std::vector<scene::Object>>(operands.size());
    const bool cuts = keyword == Kind::Intersection || keyword == Kind::Difference;
    bool all_inside = true;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        if (!operands[i].make(m, (*all)[i])) return false;
        const bool inside = has_inside((*all)[i]);
        if (cuts && !inside) return false;
        all_inside = all_inside && inside;
    }
    object.shape = scene::Csg{*csg_op(keyword), all, true, false, false, false, all_inside, {}};
    object.forgets_inverse = some_forget_inverse(object);
    return true;
}

bool ObjectRecipe::make_shape(const Making& m, scene::Object& object) const
{
    if (name != kNoIndex) {
        const scene::Object* const declared = declared_object(m, name);
        if (!declared) return false;
        object = *declared;
        if (!solid) object.source = source;
        return true;
    }
    object.source = source;
    if (solid) return solid->set(m.values + value, open, object);
    if (keyword != Kind::Object) return make_operands(m, object);
    if (!operands.front().make(m, object)) return false;
    object.source = source;
    return true;
}

bool ObjectRecipe::make(const Making& m, scene::Object& object) const
{
    return make_shape(m, object) && apply_modifiers(modifiers, m, object);
}

}  // namespace parser
