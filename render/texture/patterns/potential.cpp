#include "csg/freeform/freeform.h"
#include "render/texture/patterns/patterns.h"
#include "render/texture/points/point_lanes.h"

namespace texture {
namespace {

/// Of what the field tells.
template <class T>
T finished(const Potential& of, const Pattern& pattern, const T& field)
{
    const T value = pattern.numbers[0] != 0.0 ? field - T(of.threshold) : field;
    return of.inverse ? T(0.0) - value : value;
}

/// The field's values at eight points at a time.
void fields(const csg::Blob& blob, const Points& p, Values& out)
{
    blob.fields(p.x.data(), p.y.data(), p.z.data(), p.size(), out.data());
}
void fields(const csg::Isosurface& surface, const Points& p, Values& out)
{
    csg::EightPoints eight;
    csg::Eight told;
    const auto part = [](const Values& from, std::size_t first, csg::Eight& to) {
        std::copy_n(from.data() + first, std::size(to.v), to.v);
    };
    for (std::size_t i = 0; i < p.size(); i += std::size(told.v)) {
        part(p.x, i, eight.x);
        part(p.y, i, eight.y);
        part(p.z, i, eight.z);
        surface.terms().field->values(eight, told);
        std::copy_n(told.v, std::size(told.v), out.data() + i);
    }
}

}  // namespace

double potential(const Potential& of, const Pattern& pattern, const glm::dvec3& p)
{
    const glm::dvec3 q = of.into.linear * p + of.into.offset;
    const auto* blob = std::get_if<csg::Blob>(&of.shape->kind);
    return finished(of, pattern,
                    blob ? blob->field(q) : std::get<csg::Isosurface>(of.shape->kind).terms().field->value(q));
}

void potential_values(const Potential& of, const Pattern& pattern, const Points& p, Values& out)
{
    Points q;
    q.count = p.count;
    for (std::size_t i = 0; i < p.size(); ++i) q.set(i, of.into.linear * p.at(i) + of.into.offset);
    q.pad();
    if (const auto* blob = std::get_if<csg::Blob>(&of.shape->kind)) fields(*blob, q, out);
    else fields(std::get<csg::Isosurface>(of.shape->kind), q, out);
    for (std::size_t i = 0; i < q.size(); i += kLanes)
        finished(of, pattern, Double::load_aligned(out.data() + i)).store_aligned(out.data() + i);
}

}  // namespace texture
