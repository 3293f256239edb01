#include "render/solid/measure/body.h"

#include "csg/freeform/freeform.h"
#include "csg/items/world_data.h"

#include <algorithm>

namespace solid {
namespace {

constexpr double kIsoAccuracy = 1e-6;  // relative to the container: how exactly isosurfaces are found at least

/// The same object with isosurfaces that are found more exactly, and at once near a place, and julia sets from which no
/// crossing is left out.
scene::Object sharpened(scene::Object object)
{
    if (const auto* csg = std::get_if<scene::Csg>(&object.shape)) {
        std::vector<scene::Object> operands;
        for (const scene::Object& operand : *csg->operands) operands.push_back(sharpened(operand));
        scene::Csg made = *csg;
        made.operands = std::make_shared<const std::vector<scene::Object>>(std::move(operands));
        object.shape = std::move(made);
    } else if (const auto* freeform = std::get_if<scene::Freeform>(&object.shape)) {
        if (const auto* iso = std::get_if<csg::Isosurface>(&freeform->shape->kind)) {
            csg::IsosurfaceTerms terms = iso->terms();
            const glm::dvec3 size = iso->bounds().upper - iso->bounds().lower;
            terms.accuracy = std::min(terms.accuracy, kIsoAccuracy * glm::max(size.x, glm::max(size.y, size.z)));
            terms.short_ways = true;
            scene::Freeform made = *freeform;
            made.shape = csg::make_freeform<csg::Isosurface>(std::move(terms));
            object.shape = std::move(made);
        } else if (const auto* julia = std::get_if<csg::Julia>(&freeform->shape->kind)) {
            csg::JuliaTerms terms = julia->terms();
            terms.whole = true;
            scene::Freeform made = *freeform;
            made.shape = csg::make_freeform<csg::Julia>(terms);
            object.shape = std::move(made);
        }
    }
    return object;
}

/// The longest side of the cells of height fields.
double grain_of(const csg::WorldData& world, const csg::Transform& frame)
{
    double out = 0.0;
    for (const csg::Freeform& solid : world.store.all<csg::Freeform>())
        if (const auto* field = std::get_if<csg::HeightField>(&solid.shape->kind)) {
            const auto side = [&](const glm::dvec3& along) {
                return glm::length(frame.vector(solid.frame.vector(along)));
            };
            out = std::max({out, side({field->cell().x, 0, 0}), side({0, 0, field->cell().y})});
        }
    for (const csg::Instance& one : world.instances) out = std::max(out, grain_of(*one.world, one.frame));
    return out;
}

}  // namespace

Body::Body(const scene::Object& object, const scene::GlobalSettings& global)
    : probe_(sharpened(object), global), lines_(probe_.world().data()), grain_(grain_of(probe_.world().data(), {}))
{}

namespace {

/// Nothing is drawn at an undrawn end, and most solids know no normal there; isosurfaces do.
bool has_normal(const csg::SolidStore& store, const End& end)
{
    if (end.part == csg::kNoPart) return false;
    if (end.face != csg::kUndrawnFace) return true;
    if (csg::kind_of(end.part) != csg::SolidKind::Freeform) return false;
    return std::holds_alternative<csg::Isosurface>(store.all<csg::Freeform>()[csg::index_of(end.part)].shape->kind);
}

}  // namespace

glm::dvec3 Body::normal(const glm::dvec3& point, const End& end) const
{
    const csg::WorldData& world = probe_.world().data();
    glm::dvec3 n(0.0);
    const csg::SolidStore& store = end.instance == csg::Hit::kNoInstance ? world.store
                                                                         : world.instances[end.instance].world->store;
    if (!has_normal(store, end)) return n;
    if (end.instance == csg::Hit::kNoInstance) {
        n = csg::normal_at(world.store, end.part, end.face, end.inverted, point);
    } else {
        const csg::Instance& one = world.instances[end.instance];
        n = one.frame.normal(
            csg::normal_at(one.world->store, end.part, end.face, end.inverted, one.frame.inverse_point(point)));
    }
    const double length = glm::length(n);
    return length > 0.0 ? n / length : n;
}

bool Body::inside(const glm::dvec3& point, const glm::dvec3& along) const
{
    thread_local std::vector<Chord> chords_here;
    chords(point, along, -1e-3 * lines_.radius(), 1e-3 * lines_.radius(), chords_here);
    for (const Chord& chord : chords_here)
        if (chord.in.t <= 0.0 && chord.out.t > 0.0) return true;
    return false;
}

}  // namespace solid
