#include "render/solid/measure/body.h"

#include "csg/tree/program.h"
#include "csg/freeform/freeform.h"
#include "csg/items/world_data.h"

#include <algorithm>

namespace solid {
namespace {

constexpr double kFilm = 1e-9;         // relative to the body's size: shorter chords are left out
constexpr double kIsoAccuracy = 1e-6;  // relative to the container: how exactly isosurfaces are found at least
constexpr std::uint32_t kFewSpans = 8;

/// The same object with isosurfaces that are found more exactly, and julia sets from which no crossing is left out.
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

bool has_unsmooth(const scene::Object& object)
{
    if (const auto* csg = std::get_if<scene::Csg>(&object.shape))
        return std::any_of(csg->operands->begin(), csg->operands->end(), has_unsmooth);
    const auto* freeform = std::get_if<scene::Freeform>(&object.shape);
    return freeform != nullptr && (std::holds_alternative<csg::Isosurface>(freeform->shape->kind) ||
                                   std::holds_alternative<csg::HeightField>(freeform->shape->kind));
}

/// Around what the node and those below hold.
csg::Aabb inside_box(const csg::Program& program, const csg::SolidStore& store, std::uint32_t i)
{
    const csg::Node& node = program.nodes[i];
    if (node.op == csg::Op::Guard) return inside_box(program, store, i + 1);
    if (node.op == csg::Op::Leaf) {
        if (node.inverted) return csg::Aabb::everything();
        return csg::with_solid(store, node.solid, [](const auto& s) { return s.bounds(); });
    }
    const bool joins = node.op == csg::Op::Union || node.op == csg::Op::Merge;
    csg::Aabb box = joins ? csg::Aabb{} : csg::Aabb::everything();
    for (std::uint32_t k = i + 1; k < node.end; k = program.nodes[k].end) {
        const csg::Aabb own = inside_box(program, store, k);
        if (joins) box.include(own);
        else box = box.intersected(own);
    }
    return box;
}

csg::Aabb inside_box(const csg::WorldData& world, const csg::WorldItem& item)
{
    if (item.instance != csg::Hit::kNoInstance) {
        const csg::Instance& one = world.instances[item.instance];
        csg::Aabb own, box;
        for (const csg::WorldItem& part : one.world->items) own.include(inside_box(*one.world, part));
        if (own.empty()) return own;
        if (!own.finite()) return csg::Aabb::everything();
        for (int corner = 0; corner < 8; ++corner)
            box.include(one.frame.point({(corner & 1) != 0 ? own.upper.x : own.lower.x,
                                         (corner & 2) != 0 ? own.upper.y : own.lower.y,
                                         (corner & 4) != 0 ? own.upper.z : own.lower.z}));
        return box;
    }
    if (item.solid == csg::kNoPart) {
        const csg::Program& program = world.programs[item.program];
        if (program.nodes.empty()) return {};
        const csg::Aabb box = inside_box(program, world.store, 0);
        const bool clipped = std::any_of(program.nodes.begin(), program.nodes.end(),
                                         [](const csg::Node& node) { return node.op == csg::Op::Clip; });
        return clipped || program.inside_beyond ? box : box.intersected(program.bounds);
    }
    if (item.inverted) return csg::Aabb::everything();
    if (csg::kind_of(item.solid) == csg::SolidKind::Mesh) {
        const csg::Mesh& mesh = world.store.all<csg::Mesh>()[csg::index_of(item.solid)];
        return mesh.solid() ? mesh.bounds() : csg::Aabb{};
    }
    if (csg::kind_of(item.solid) == csg::SolidKind::Triangle) return {};
    return csg::with_solid(world.store, item.solid, [](const auto& s) {
        if constexpr (std::is_same_v<std::decay_t<decltype(s)>, csg::Freeform>)
            return s.surface() ? csg::Aabb{} : s.bounds();
        else return s.bounds();
    });
}

void push(const csg::Span& span, std::uint32_t instance, double scale, std::vector<Chord>& out)
{
    const auto end = [&](const csg::Crossing& c) { return End{c.t * scale, c.part, c.face, instance, c.inverted}; };
    out.push_back({end(span.in), end(span.out)});
}

void item_chords(const csg::WorldData& world, const csg::WorldItem& item, const csg::Ray& ray, double from, double to,
                 csg::Scratch& scratch, std::uint32_t instance, double scale, std::vector<Chord>& out)
{
    if (item.instance != csg::Hit::kNoInstance) {
        const csg::Instance& one = world.instances[item.instance];
        csg::Ray local{one.frame.inverse_point(ray.origin), one.frame.inverse_vector(ray.direction)};
        const double length = glm::length(local.direction);
        local.direction /= length;
        for (const csg::WorldItem& part : one.world->items)
            item_chords(*one.world, part, local, from * length, to * length, scratch, item.instance, 1.0 / length, out);
        return;
    }
    if (item.solid == csg::kNoPart) {
        const csg::Program& program = world.programs[item.program];
        if (program.nodes.empty()) return;
        for (const csg::Span& span : csg::Evaluation(program, world.store, ray, from, to, scratch).inside())
            push(span, instance, scale, out);
        return;
    }
    csg::with_solid(world.store, item.solid, [&](const auto& solid) {
        using T = std::decay_t<decltype(solid)>;
        const auto stamped = [&](csg::SpanList& spans) {
            for (csg::Span& span : spans) {
                span.in.part = span.out.part = item.solid;
                span.in.inverted = span.out.inverted = item.inverted;
                push(span, instance, scale, out);
            }
        };
        if constexpr (std::is_same_v<T, csg::Triangle>) {
            return;
        } else if constexpr (std::is_same_v<T, csg::Mesh>) {
            if (!solid.solid()) return;
            std::vector<csg::Span> memory(solid.most_spans());
            csg::SpanList spans(memory.data(), static_cast<std::uint32_t>(memory.size()));
            solid.spans(ray, item.inverted, spans);
            stamped(spans);
        } else {
            // Kept: to clear room for the spans of an isosurface costs as much as many a line through one.
            constexpr std::uint32_t kMost = std::max(csg::most_plain_spans<T>(), kFewSpans);
            thread_local csg::Span memory[kMost], other[kMost + 1];
            csg::SpanList spans(memory, kMost), beyond(other, kMost + 1);
            if constexpr (std::is_same_v<T, csg::Freeform>) {
                if (solid.surface()) return;
                solid.spans(ray, from, to, spans);
            } else {
                csg::intersect(solid, ray, spans);
            }
            if (item.inverted) csg::complement(spans, beyond);
            stamped(item.inverted ? beyond : spans);
        }
    });
}

/// Chords of several items as those of their union, without films.
void unite(std::vector<Chord>& chords, double slack)
{
    if (!std::is_sorted(chords.begin(), chords.end(), [](const Chord& a, const Chord& b) { return a.in.t < b.in.t; }))
        std::sort(chords.begin(), chords.end(), [](const Chord& a, const Chord& b) { return a.in.t < b.in.t; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < chords.size(); ++i) {
        if (kept > 0 && chords[i].in.t <= chords[kept - 1].out.t + slack) {
            if (chords[i].out.t > chords[kept - 1].out.t) chords[kept - 1].out = chords[i].out;
        } else {
            chords[kept++] = chords[i];
        }
    }
    chords.resize(kept);
    std::erase_if(chords, [&](const Chord& c) { return !(c.length() > slack); });
}

}  // namespace

std::pair<double, double> line_in_box(const csg::Aabb& box, const csg::Ray& line, double room)
{
    double from = -csg::kInfinity, to = csg::kInfinity;
    for (int k = 0; k < 3; ++k) {
        const double low = box.lower[k] - room - line.origin[k], high = box.upper[k] + room - line.origin[k];
        if (line.direction[k] == 0.0) {
            if (low > 0.0 || high < 0.0) return {1.0, 0.0};
            continue;
        }
        const double a = low / line.direction[k], b = high / line.direction[k];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return {from, to};
}

Body::Body(const scene::Object& object, const scene::GlobalSettings& global)
    : probe_(sharpened(object), global), unsmooth_(has_unsmooth(object))
{
    const csg::WorldData& world = probe_.world().data();
    for (const csg::WorldItem& item : world.items) {
        boxes_.push_back(inside_box(world, item));
        bounds_.include(boxes_.back());
    }
    if (bounds_.empty() || !bounds_.finite()) return;
    middle_ = 0.5 * (bounds_.lower + bounds_.upper);
    radius_ = 0.5 * glm::length(bounds_.upper - bounds_.lower);
    slack_ = kFilm * std::max(radius_, 1e-3 * glm::length(middle_));
}

void Body::chords(const glm::dvec3& point, const glm::dvec3& direction, double from, double to,
                  std::vector<Chord>& out) const
{
    thread_local csg::Scratch scratch;
    out.clear();
    const bool ends = radius_ > 0.0;  // else the line is followed from where it is asked for
    const double back = ends ? glm::dot(point - middle_, direction) + 1.1 * radius_ : -from;
    const csg::Ray ray{point - back * direction, direction};
    const csg::WorldData& world = probe_.world().data();
    const double first = std::max(0.0, from + back), last = ends ? std::min(to + back, 3.0 * radius_) : to + back;
    const bool many = world.items.size() > 1;
    for (std::size_t i = 0; i < world.items.size(); ++i) {
        if (many) {
            const auto [in, out_of] = line_in_box(boxes_[i], ray, slack_);
            if (!(std::max(in, first - slack_) <= std::min(out_of, last + slack_))) continue;
        }
        item_chords(world, world.items[i], ray, first, last, scratch, csg::Hit::kNoInstance, 1.0, out);
    }
    unite(out, slack_);
    for (Chord& chord : out) {
        chord.in.t -= back;
        chord.out.t -= back;
    }
}

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
    chords(point, along, -1e-3 * radius_, 1e-3 * radius_, chords_here);
    for (const Chord& chord : chords_here)
        if (chord.in.t <= 0.0 && chord.out.t > 0.0) return true;
    return false;
}

}  // namespace solid
