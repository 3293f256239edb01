#include "render/explain/ray_spans.h"

#include "csg/tree/program.h"
#include "csg/tree/evaluate.h"
#include "render/plan/compiled_scene.h"
#include "render/plan/geometry/extent.h"

#include <algorithm>
#include <cmath>

namespace explain {
namespace {

using Pieces = std::vector<Piece>;

constexpr double kWhole = numbers::kInfinity;

Pieces everything() { return {{{-kWhole, nullptr}, {kWhole, nullptr}}}; }

Pieces complement(const Pieces& a)
{
    Pieces out;
    End from{-kWhole, nullptr};
    for (const Piece& piece : a) {
        if (piece.in.t > from.t) out.push_back({from, piece.in});
        from = piece.out;
    }
    if (from.t < kWhole) out.push_back({from, {kWhole, nullptr}});
    return out;
}

Pieces intersected(const Pieces& a, const Pieces& b)
{
    Pieces out;
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
        const End& in = a[i].in.t >= b[j].in.t ? a[i].in : b[j].in;
        const End& end = a[i].out.t <= b[j].out.t ? a[i].out : b[j].out;
        if (in.t < end.t) out.push_back({in, end});
        a[i].out.t <= b[j].out.t ? ++i : ++j;
    }
    return out;
}

Pieces united(const Pieces& a, const Pieces& b)
{
    Pieces all = a, out;
    all.insert(all.end(), b.begin(), b.end());
    std::stable_sort(all.begin(), all.end(), [](const Piece& x, const Piece& y) { return x.in.t < y.in.t; });
    for (const Piece& piece : all) {
        if (out.empty() || piece.in.t > out.back().out.t) out.push_back(piece);
        else if (piece.out.t > out.back().out.t) out.back().out = piece.out;
    }
    return out;
}

/// Where the ray is in the box, from its start on; infinite where it never is.
double entry_of(const csg::Aabb& box, const csg::Ray& ray)
{
    double first = 0.0, last = kWhole;
    for (int k = 0; k < 3; ++k) {
        const double o = ray.origin[k], d = ray.direction[k];
        if (d == 0.0) {
            if (o < box.lower[k] || o > box.upper[k]) return kWhole;
            continue;
        }
        const double a = (box.lower[k] - o) / d, b = (box.upper[k] - o) / d;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first <= last ? first : kWhole;
}

}  // namespace

/// A leaf by itself, in the world.
struct RaySpans::Leaf {
    csg::Transform parent;
    plan::CompiledScene compiled;
    csg::Program program;  ///< empty: nothing inside
};

RaySpans::RaySpans(const scene::Description& description) : description_(description)
{
    constexpr double kSlack = 1e-5;  // boxes are in single precision
    for (const scene::Object& object : description.objects) {
        csg::Aabb box = is_light(object) ? csg::Aabb{} : plan::described_extent(object);
        const glm::dvec3 slack = kSlack * (1.0 + glm::max(glm::abs(box.lower), glm::abs(box.upper)));
        if (!box.empty()) box = {box.lower - slack, box.upper + slack};
        if (object.inverse) box = csg::Aabb::everything();
        boxes_.push_back(box);
    }
}

RaySpans::~RaySpans() = default;

std::vector<ObjectSpans> RaySpans::along(const csg::Ray& ray, std::size_t most)
{
    std::vector<std::pair<double, const scene::Object*>> met;
    std::size_t i = 0;
    for (const scene::Object& object : description_.objects) {
        const csg::Aabb& box = boxes_[i++];
        const double entry = box.empty() ? kWhole : entry_of(box, ray);
        if (entry < kWhole) met.emplace_back(entry, &object);
    }
    std::stable_sort(met.begin(), met.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    if (met.size() > most) met.resize(most);
    std::vector<ObjectSpans> out;
    for (const auto& [entry, object] : met) {
        Pieces pieces = inside(*object, {}, ray);
        std::erase_if(pieces, [](const Piece& piece) { return piece.out.t <= 0.0; });
        if (!pieces.empty()) out.push_back({object, std::move(pieces)});
    }
    const auto first = [](const ObjectSpans& spans) {
        const Piece& piece = spans.pieces.front();
        return piece.in.t > 0.0 ? piece.in.t : piece.out.t;
    };
    std::stable_sort(out.begin(), out.end(),
                     [&](const ObjectSpans& a, const ObjectSpans& b) { return first(a) < first(b); });
    return out;
}

std::vector<Piece> RaySpans::inside(const scene::Object& object, const csg::Transform& parent, const csg::Ray& ray)
{
    Pieces out = shape_inside(object, parent, ray);
    if (object.inverse) out = complement(out);
    for (const scene::Object& clip : object.details->clipped_by) out = intersected(out, inside(clip, parent, ray));
    return out;
}

std::vector<Piece> RaySpans::shape_inside(const scene::Object& object, const csg::Transform& parent,
                                          const csg::Ray& ray)
{
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    if (csg == nullptr) return leaf_inside(object, parent, ray);
    const csg::Transform own = parent * *object.transform;
    const bool adds = csg->op == scene::CsgOp::Union || csg->op == scene::CsgOp::Merge;
    Pieces out = adds ? Pieces{} : everything();
    bool first = true;
    for (const scene::Object& operand : *csg->operands) {
        if (is_light(operand)) continue;
        const Pieces here = inside(operand, own, ray);
        if (adds) out = united(out, here);
        else if (csg->op == scene::CsgOp::Difference && !first) out = intersected(out, complement(here));
        else out = intersected(out, here);
        first = false;
        if (!adds && out.empty()) break;
    }
    return out;
}

std::vector<Piece> RaySpans::leaf_inside(const scene::Object& object, const csg::Transform& parent, const csg::Ray& ray)
{
    const auto same = [&](const csg::Transform& t) { return t.linear == parent.linear && t.offset == parent.offset; };
    auto& known = leaves_[&object];
    auto at = std::find_if(known.begin(), known.end(), [&](const auto& leaf) { return same(leaf->parent); });
    if (at == known.end()) {
        scene::Description alone;
        alone.global = description_.global;
        alone.effective_version = description_.effective_version;
        alone.povray = description_.povray;
        auto texture = std::make_shared<scene::Texture>();
        texture->kind = std::vector<scene::Layer>{scene::Layer{}};
        alone.default_texture = texture;
        scene::Object copy;
        copy.shape = object.shape;
        if (auto* plane = std::get_if<scene::Plane>(&copy.shape)) plane->moved_clips = false;  // it has none
        copy.transform = parent * *object.transform;
        copy.details.edit().written = object.details->written;
        copy.source = object.source;
        alone.objects.push_back(copy);
        auto leaf = std::make_unique<Leaf>(Leaf{parent, plan::compile(alone, {}), {}});
        const csg::WorldData& world = leaf->compiled.geometry;
        if (!world.items.empty()) {
            const csg::WorldItem& item = world.items.front();
            if (item.solid == csg::kNoPart && item.instance == csg::Hit::kNoInstance)
                leaf->program = world.programs[item.program];
            else if (item.solid != csg::kNoPart) leaf->program = csg::build(csg::Tree::leaf(item.solid), world.store);
        }
        known.push_back(std::move(leaf));
        at = std::prev(known.end());
    }
    const Leaf& leaf = **at;
    if (leaf.program.nodes.empty()) return {};
    csg::Scratch scratch;
    Pieces out;
    for (const csg::Span& span : csg::inside_spans(leaf.program, leaf.compiled.geometry.store, ray, scratch))
        out.push_back({{span.in.t, std::isfinite(span.in.t) ? &object : nullptr},
                       {span.out.t, std::isfinite(span.out.t) ? &object : nullptr}});
    return out;
}

}  // namespace explain
