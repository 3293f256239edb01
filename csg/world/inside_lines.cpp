#include "csg/world/inside_lines.h"

#include "csg/packet/lane_front.h"
#include "csg/packet/packet_walk.h"
#include "csg/tree/evaluate.h"

#include <algorithm>

namespace csg {
namespace {

constexpr double kFilm = 1e-9;  // relative to the size of the inside: shorter chords are left out
constexpr std::uint32_t kFewSpans = 8;

/// Around what the node and those below hold.
Aabb inside_box(const Program& program, const SolidStore& store, std::uint32_t i)
{
    const Node& node = program.nodes[i];
    if (node.op == Op::Guard) return inside_box(program, store, i + 1);
    if (node.op == Op::Leaf) {
        if (node.inverted) return Aabb::everything();
        return with_solid(store, node.solid, [](const auto& s) { return s.bounds(); });
    }
    const bool joins = node.op == Op::Union || node.op == Op::Merge;
    Aabb box = joins ? Aabb{} : Aabb::everything();
    for (std::uint32_t k = i + 1; k < node.end; k = program.nodes[k].end) {
        const Aabb own = inside_box(program, store, k);
        if (joins) box.include(own);
        else box = box.intersected(own);
    }
    return box;
}

Aabb inside_box(const WorldData& world, const WorldItem& item)
{
    if (item.instance != Hit::kNoInstance) {
        const Instance& one = world.instances[item.instance];
        Aabb own, box;
        for (const WorldItem& part : one.world->items) own.include(inside_box(*one.world, part));
        if (own.empty()) return own;
        if (!own.finite()) return Aabb::everything();
        for (int corner = 0; corner < 8; ++corner)
            box.include(one.frame.point({(corner & 1) != 0 ? own.upper.x : own.lower.x,
                                         (corner & 2) != 0 ? own.upper.y : own.lower.y,
                                         (corner & 4) != 0 ? own.upper.z : own.lower.z}));
        return box;
    }
    if (item.solid == kNoPart) {
        const Program& program = world.programs[item.program];
        if (program.nodes.empty()) return {};
        const Aabb box = inside_box(program, world.store, 0);
        const bool clipped = std::any_of(program.nodes.begin(), program.nodes.end(),
                                         [](const Node& node) { return node.op == Op::Clip; });
        return clipped || program.inside_beyond ? box : box.intersected(program.bounds);
    }
    if (item.inverted) return Aabb::everything();
    if (kind_of(item.solid) == SolidKind::Mesh) {
        const Mesh& mesh = world.store.all<Mesh>()[index_of(item.solid)];
        return mesh.solid() ? mesh.bounds() : Aabb{};
    }
    if (kind_of(item.solid) == SolidKind::Triangle) return {};
    return with_solid(world.store, item.solid, [](const auto& s) {
        if constexpr (std::is_same_v<std::decay_t<decltype(s)>, Freeform>) return s.surface() ? Aabb{} : s.bounds();
        else return s.bounds();
    });
}

void push(const Span& span, std::uint32_t instance, double scale, std::vector<Chord>& out)
{
    const auto end = [&](const Crossing& c) { return LineEnd{c.t * scale, c.part, c.face, instance, c.inverted}; };
    out.push_back({end(span.in), end(span.out)});
}

void item_chords(const WorldData& world, const WorldItem& item, const Ray& ray, double from, double to,
                 Scratch& scratch, std::uint32_t instance, double scale, std::vector<Chord>& out)
{
    if (item.instance != Hit::kNoInstance) {
        const Instance& one = world.instances[item.instance];
        Ray local{one.frame.inverse_point(ray.origin), one.frame.inverse_vector(ray.direction)};
        const double length = glm::length(local.direction);
        local.direction /= length;
        for (const WorldItem& part : one.world->items)
            item_chords(*one.world, part, local, from * length, to * length, scratch, item.instance, 1.0 / length, out);
        return;
    }
    if (item.solid == kNoPart) {
        const Program& program = world.programs[item.program];
        if (program.nodes.empty()) return;
        for (const Span& span : Evaluation(program, world.store, ray, from, to, scratch).inside())
            push(span, instance, scale, out);
        return;
    }
    with_solid(world.store, item.solid, [&](const auto& solid) {
        using T = std::decay_t<decltype(solid)>;
        const auto stamped = [&](SpanList& spans) {
            for (Span& span : spans) {
                span.in.part = span.out.part = item.solid;
                span.in.inverted = span.out.inverted = item.inverted;
                push(span, instance, scale, out);
            }
        };
        if constexpr (std::is_same_v<T, Triangle>) {
            return;
        } else if constexpr (std::is_same_v<T, Mesh>) {
            if (!solid.solid()) return;
            std::vector<Span> memory(solid.most_spans());
            SpanList spans(memory.data(), static_cast<std::uint32_t>(memory.size()));
            solid.spans(ray, item.inverted, spans);
            stamped(spans);
        } else {
            // Kept: to clear room for the spans of an isosurface costs as much as many a line through one. Not as
            // arrays, which every thread would get when it begins, 35 KB of them.
            constexpr std::uint32_t kMost = std::max(most_plain_spans<T>(), kFewSpans);
            thread_local std::vector<Span> memory(kMost), other(kMost + 1);
            SpanList spans(memory.data(), kMost), beyond(other.data(), kMost + 1);
            if constexpr (std::is_same_v<T, Freeform>) {
                if (solid.surface()) return;
                solid.spans(ray, from, to, spans);
            } else {
                intersect(solid, ray, spans);
            }
            if (item.inverted) complement(spans, beyond);
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

std::pair<double, double> line_in_box(const Aabb& box, const Ray& line, double room)
{
    double from = -kInfinity, to = kInfinity;
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

InsideLines::InsideLines(const WorldData& world) : world_(world)
{
    for (const WorldItem& item : world.items) {
        boxes_.push_back(inside_box(world, item));
        bounds_.include(boxes_.back());
    }
    if (!bounds_.empty() && bounds_.finite()) {
        middle_ = 0.5 * (bounds_.lower + bounds_.upper);
        radius_ = 0.5 * glm::length(bounds_.upper - bounds_.lower);
        slack_ = kFilm * std::max(radius_, 1e-3 * glm::length(middle_));
    }
    constexpr std::size_t kFewest = 4;  // for a hierarchy
    std::vector<BvhInput> inputs;
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
        if (boxes_[i].empty()) continue;
        const Aabb box{boxes_[i].lower - slack_, boxes_[i].upper + slack_};
        if (boxes_.size() >= kFewest && fits_hierarchy(box)) inputs.push_back({.bounds = box, .index = i});
        else apart_.push_back(i);
    }
    hierarchy_ = build_bvh(std::move(inputs));
}

InsideLines::Followed InsideLines::followed(const Ray& line, double from, double to) const
{
    const bool ends = radius_ > 0.0;  // else the line is followed from where it is asked for
    const double back = ends ? glm::dot(line.origin - middle_, line.direction) + 1.1 * radius_ : -from;
    return {{line.origin - back * line.direction, line.direction},
            back,
            std::max(0.0, from + back),
            ends ? std::min(to + back, 3.0 * radius_) : to + back};
}

void InsideLines::finish(std::vector<Chord>& chords, double back) const
{
    unite(chords, slack_);
    for (Chord& chord : chords) {
        chord.in.t -= back;
        chord.out.t -= back;
    }
}

void InsideLines::chords(const Ray& line, double from, double to, std::vector<Chord>& out) const
{
    thread_local Scratch scratch;
    out.clear();
    const Followed way = followed(line, from, to);
    const bool many = world_.items.size() > 1;
    for (std::size_t i = 0; i < world_.items.size(); ++i) {
        if (many) {
            const auto [in, out_of] = line_in_box(boxes_[i], way.ray, slack_);
            if (!(std::max(in, way.first - slack_) <= std::min(out_of, way.last + slack_))) continue;
        }
        item_chords(world_, world_.items[i], way.ray, way.first, way.last, scratch, Hit::kNoInstance, 1.0, out);
    }
    finish(out, way.back);
}

/// Items of a world against a tile of lines: in vector lanes what has a test for them, the rest line by line.
class InsideLines::TileLeaf {
public:
    using Rays = TileRays<OwnOrigins>;

    TileLeaf(const WorldData& world, const Rays& rays, const PacketSlabs<Rays>& slabs, Scratch& scratch, ChordTile& out)
        : world_(world), rays_(rays), front_(world.store, slabs, rays), scratch_(scratch), out_(out)
    {}

    void open(ChildWord leaf, RayMask mask) { item(leaf.index(), mask); }

    void item(std::uint32_t index, RayMask mask)
    {
        const WorldItem& item = world_.items[index];
        const bool several = (mask & (mask - 1)) != 0;
        if (several && item.instance == Hit::kNoInstance) {
            if (item.solid == kNoPart && item.simple) mask = by_products(item, mask);
            else if (item.solid != kNoPart && !item.inverted && lanes::has_test(world_.store, item.solid))
                return lanes::with_test(world_.store, item.solid, rays_,
                                        [&](const auto& at) { take(item.solid, mask, at); });
            else if (kind_of(item.solid) == SolidKind::Torus && !item.inverted) mask = of_torus(item.solid, mask);
            else if (item.many && !item.inverted && kind_of(item.solid) == SolidKind::Freeform)
                return together(item, mask);
        }
        each_ray(mask, [&](std::size_t k) {
            item_chords(world_, item, rays_.ray(static_cast<int>(k)), rays_.t_min[k], rays_.limit[k], scratch_,
                        Hit::kNoInstance, 1.0, out_[k]);
        });
    }

private:
    /// A part of each line, as at(i) tells of those from i on.
    template <class At>
    void take(PartId part, RayMask mask, const At& at)
    {
        each_vector(mask, [&](int i) {
            const lanes::Intervals own = at(i);
            RayMask met = RayMask{lanes::mask(own.met & (own.entry <= own.exit))} << i & mask;
            if (met == 0) return;
            alignas(64) double t[2][lanes::kDoubles], face[2][lanes::kDoubles];
            own.entry.store_aligned(t[0]);
            own.exit.store_aligned(t[1]);
            own.entry_face.store_aligned(face[0]);
            own.exit_face.store_aligned(face[1]);
            for (; met != 0; met &= met - 1) {
                const auto k = static_cast<std::size_t>(std::countr_zero(met)), lane = k - static_cast<std::size_t>(i);
                const auto end = [&](std::size_t side) {
                    return LineEnd{t[side][lane], part, static_cast<std::uint32_t>(face[side][lane])};
                };
                out_[k].push_back({end(0), end(1)});
            }
        });
    }

    /// Returns the lines that remain to be asked one by one.
    RayMask of_torus(PartId part, RayMask mask)
    {
        const Torus& torus = world_.store.all<Torus>()[index_of(part)];
        if (!detail::factors_serve(torus)) return mask;
        const TorusEnds ends(torus, rays_, mask);
        for (std::size_t which = 0; which < 2; ++which)
            take(part, ends.met[which], [&](int i) { return ends.piece(static_cast<int>(which), i); });
        return ends.unclear;
    }

    /// Returns the lines that remain to be asked one by one.
    RayMask by_products(const WorldItem& item, RayMask mask)
    {
        const SumOfProducts& form = world_.programs[item.program].products;
        front_.ask_all(form, mask);
        RayMask left = front_.undecided;
        each_ray(front_.found, [&](std::size_t k) {
            const bool ends = front_.entry(k) > -kInfinity && front_.exit(k) < kInfinity;
            const std::size_t before = out_[k].size();
            bool in = false;
            const auto take = [&](double t, const LeafEnd& at) {
                const ProductLeaf& leaf = form.leaves[at.leaf];
                const LineEnd end{t, leaf.solid, at.face, Hit::kNoInstance, leaf.normal_flipped};
                if (in) out_[k].back().out = end;
                else out_[k].push_back({end, end});
                in = !in;
            };
            if (ends && front_.each_crossing(k, take) && !in) return;
            out_[k].resize(before);
            left |= RayMask{1} << k;
        });
        return left;
    }

    /// A solid that answers many lines together.
    void together(const WorldItem& item, RayMask mask)
    {
        const Freeform& solid = world_.store.all<Freeform>()[index_of(item.solid)];
        if (solid.surface()) return;
        RayBatch& batch = scratch_.batch();
        each_ray(mask, [&](std::size_t k) {
            batch.add(rays_.ray(static_cast<int>(k)), k, rays_.t_min[k], rays_.limit[k], false);
        });
        solid.intersect_many(batch);
        for (std::size_t i = 0; i < batch.count; ++i)
            batch.records[i].each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                out_[batch.place[i]].push_back({{in, item.solid, in_face}, {out, item.solid, out_face}});
            });
    }

    const WorldData& world_;
    const Rays& rays_;
    LaneFront<Rays> front_;
    Scratch& scratch_;
    ChordTile& out_;
};

void InsideLines::chords(const LineTile& lines, ChordTile& out) const
{
    if (lines.count == 0) return;
    thread_local Scratch scratch;
    RayTile tile;
    std::array<double, kTileRays> back;
    tile.count = static_cast<int>(lines.count);
    for (std::size_t k = 0; k < lines.count; ++k) {
        const Followed way = followed(lines.lines[k], lines.from[k], lines.to[k]);
        back[k] = way.back;
        tile.set(k, way.ray, way.first, way.last);
        out[k].clear();
    }
    const TileRays<OwnOrigins> rays(tile);
    const PacketSlabs<TileRays<OwnOrigins>> slabs(rays);
    TileLeaf leaf(world_, rays, slabs, scratch, out);
    for (const std::uint32_t i : apart_) {
        const Aabb& box = boxes_[i];
        const bool asks = box.finite() && world_.items.size() > 1;
        leaf.item(i, asks ? rays.intersect(box.lower - slack_, box.upper + slack_, rays.all()) : rays.all());
    }
    PacketWalk(hierarchy_, slabs, rays, ~0u, leaf).run();
    for (std::size_t k = 0; k < lines.count; ++k) finish(out[k], back[k]);
}

}  // namespace csg
