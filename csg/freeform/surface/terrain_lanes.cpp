#include "numbers/lane_words.h"
#include "csg/freeform/surface/terrain_walk.h"

#include <bit>
#include <optional>

namespace csg {

#if defined(__AVX2__)

/// Walks of many rays, a ray a lane: the same steps with the same numbers as TerrainWalk's own. A ray below the terrain
/// is one above it where all heights have the other sign, which rounding leaves alone. A lane that meets the terrain
/// waits until some others do; one whose ray is done takes the next.
class TerrainLanes {
public:
    TerrainLanes(const HeightField& field, std::span<const Ray> rays, IntersectionList* out)
        : field_(field), rays_(rays), out_(out)
    {}
    void run();

private:
    using Double = lanes::Double;
    using Bool = Double::batch_bool_type;
    using Mask = std::uint32_t;
    static constexpr std::size_t kLanes = Double::size;
    static constexpr std::size_t kGroups = 2;  ///< in turn: a step of one begins while the other's is not yet done
    static constexpr int kEnough = kLanes > 4 ? 4 : 3;  ///< lanes that wait, to look at them

    struct alignas(64) Numbers : std::array<double, kLanes> {
        Double load() const { return Double::load_aligned(data()); }
        void store(const Double& v) { v.store_aligned(data()); }
    };
    struct Group {
        Numbers ox{}, oy{}, oz{}, dx{}, dy{}, dz{}, ix{}, iz{}, right{}, up{}, end{}, limit{};
        Numbers t{}, y{}, i{}, k{}, size{}, inverse{};  ///< of each walk's place
        Numbers row{};                                  ///< where its level begins, as if cells lay before the blocks
        Numbers sign{};                                 ///< of heights: -1 of rays below the terrain
        Numbers above{};                                ///< the terrain, where known
        Numbers met_t{};                                ///< where it meets the terrain,
        Mask found = 0, upper = 0;                      ///< of those: in the cell's second triangle
        Mask going = 0, met = 0, ended = 0;
        Mask under = 0;  ///< rays below the terrain
        Mask known = 0;  ///< those that have just come over a cell's triangles
        std::array<std::optional<TerrainWalk>, kLanes> walks;
    };
    /// A step of every lane: the place, where it ends, and what lies below.
    struct Part {
        Double t, y, i, k, to, y_to, low, high;
        std::array<Double, 4> corners;  ///< of cells
    };

    void take_next(Group& group, std::size_t lane);
    void look(Group& group, std::size_t lane);
    void advance(Group& group) const;
    void read(Part& part, const Group& group, const Double& row, Mask blocks, Mask cells) const;
    Mask clear(Group& group, const Part& part, Mask cells) const;

    const HeightField& field_;
    std::span<const Ray> rays_;
    IntersectionList* out_;
    std::size_t next_ = 0;
    std::array<Group, kGroups> groups_;
};

void TerrainLanes::run()
{
    for (std::size_t lane = 0; lane < kLanes; ++lane)
        for (Group& group : groups_) take_next(group, lane);
    Mask going = 0;
    do {
        going = 0;
        for (Group& group : groups_) {
            if (group.going == 0) continue;
            advance(group);
            const Mask waiting = group.met | group.ended;
            if (group.going == 0 || std::popcount(waiting) >= kEnough)
                for (Mask left = waiting; left != 0; left &= left - 1)
                    look(group, static_cast<std::size_t>(std::countr_zero(left)));
            going |= group.going;
        }
    } while (going != 0);
}

/// The next ray that has to walk.
void TerrainLanes::take_next(Group& group, std::size_t lane)
{
    while (next_ < rays_.size()) {
        const std::size_t n = next_++;
        const Ray ray{rays_[n].origin * field_.scale_, rays_[n].direction * field_.scale_};
        const glm::dvec3 &o = ray.origin, &d = ray.direction;
        TerrainWalk& walk = group.walks[lane].emplace(field_, ray, out_[n]);
        if (!walk.start()) continue;
        const TerrainWalk::Place at = walk.first_place();
        if (walk.done_ || d.x == 0.0 || d.z == 0.0 || at.t > walk.out_.to) {
            walk.walk(at);
            walk.finish();
            continue;
        }
        const HeightField::Level& top = field_.levels_.back();
        const double sign = walk.inside_ ? -1.0 : 1.0;
        group.sign[lane] = sign;
        group.under = (group.under & ~(1u << lane)) | ((walk.inside_ ? 1u : 0u) << lane);
        group.ox[lane] = o.x, group.oy[lane] = sign * o.y, group.oz[lane] = o.z;
        group.dx[lane] = d.x, group.dy[lane] = sign * d.y, group.dz[lane] = d.z;
        group.ix[lane] = walk.inverse_.x, group.iz[lane] = walk.inverse_.z;
        group.right[lane] = d.x > 0.0 ? 1.0 : 0.0, group.up[lane] = d.z > 0.0 ? 1.0 : 0.0;
        group.end[lane] = walk.end_, group.limit[lane] = walk.out_.to;
        group.t[lane] = at.t, group.y[lane] = sign * at.y, group.i[lane] = at.i, group.k[lane] = at.k;
        group.size[lane] = top.size, group.inverse[lane] = 1.0 / top.size, group.row[lane] = top.first;
        group.known &= ~(1u << lane);
        group.found &= ~(1u << lane);
        group.going |= 1u << lane;
        return;
    }
}

/// A lane that waits: its ray is done, has met a cell's triangles or is beyond the terrain.
void TerrainLanes::look(Group& group, std::size_t lane)
{
    TerrainWalk& walk = *group.walks[lane];
    const Mask bit = 1u << lane;
    const bool met = (group.met & bit) != 0;
    group.met &= ~bit;
    group.ended &= ~bit;
    if (met) {
        const auto size = static_cast<std::uint32_t>(group.size[lane]);
        const TerrainWalk::Place at{static_cast<std::size_t>(std::countr_zero(size)) / TerrainWalk::kWideBits,
                                    static_cast<std::int32_t>(group.i[lane]), static_cast<std::int32_t>(group.k[lane]),
                                    group.t[lane], group.sign[lane] * group.y[lane]};
        const double t = group.met_t[lane];
        if ((group.found & bit) != 0 && walk.out_.first_only && t >= walk.out_.from && t <= walk.out_.to) {
            const bool upper = (group.upper & bit) != 0;
            walk.cross(t, walk.face_of(static_cast<std::uint32_t>(at.i), static_cast<std::uint32_t>(at.k), upper));
            return take_next(group, lane);  // no more is wanted
        }
        walk.known_ = (group.known & bit) != 0;
        walk.t_ = at.t;
        walk.above_ = group.sign[lane] * group.above[lane];
        walk.walk(at);
    }
    walk.finish();
    take_next(group, lane);
}

/// Lowest and highest levels of blocks and of cells, and a cell's corners as HeightField::corners() has them.
inline void TerrainLanes::read(Part& part, const Group& group, const Double& row, Mask blocks, Mask cells) const
{
    const Double pitch(static_cast<double>(field_.levels_[1].columns)),
        columns(static_cast<double>(field_.grid_.columns));
    const Double block = (row + part.k) * pitch + part.i, cell = part.k * columns + part.i;
    const std::uint16_t* const levels = field_.grid_.levels.data();
    using lanes::WordPairs;
    WordPairs range = WordPairs::gather(field_.ranges_.data(), block, blocks);
    if (cells != 0) {
        const WordPairs a = WordPairs::gather(levels, cell, cells),
                        b = WordPairs::gather(levels + field_.grid_.columns, cell, cells);
        part.corners = {a.first(), a.second(), b.first(), b.second()};
        range.replace(cells, WordPairs::range(a, b));
    }
    part.low = range.first();
    part.high = range.second();
    if (group.under == 0) return;
    const Bool under = lanes::lanes_of(group.under);
    const Double low = part.low, sign = group.sign.load();
    part.low = xsimd::select(under, -part.high, low);
    part.high = xsimd::select(under, -low, part.high);
    if (cells != 0)
        for (Double& corner : part.corners) corner *= sign;
}

/// Which of them stay above the triangles of their cells: TerrainWalk::triangles(). Finds where others meet them.
inline TerrainLanes::Mask TerrainLanes::clear(Group& group, const Part& part, Mask cells) const
{
    const Double zero(0.0), one(1.0);
    const auto& h = part.corners;
    // A ray on the terrain counts as above it, and so has crossed it if it comes from below.
    const auto below = [&](const Double& above) {
        const Mask less = lanes::mask(above < zero);
        return group.under == 0 ? less : (less & ~group.under) | (~lanes::mask(above > zero) & group.under);
    };
    const auto in_cell = [&](const Double& v) { return xsimd::min(xsimd::max(v, zero), one); };
    const auto level = [&](const Double& x, const Double& z) {  // terrain_level()
        return xsimd::select(x + z <= one, h[0] + (h[1] - h[0]) * x + (h[2] - h[0]) * z,
                             h[3] + (h[2] - h[3]) * (one - x) + (h[1] - h[3]) * (one - z));
    };
    const Double ox = group.ox.load(), oz = group.oz.load(), dx = group.dx.load(), dz = group.dz.load();
    const Double x0 = in_cell(ox + part.t * dx - part.i), z0 = in_cell(oz + part.t * dz - part.k),
                 x1 = in_cell(ox + part.to * dx - part.i), z1 = in_cell(oz + part.to * dz - part.k);
    const Double s0 = x0 + z0 - one, s1 = x1 + z1 - one;
    const Double first = part.y - level(x0, z0), last = part.y_to - level(x1, z1);
    const Double middle = part.t + (part.to - part.t) * (s0 / (s0 - s1));
    const Double between = group.oy.load() + middle * group.dy.load() -
                           (h[1] + (h[2] - h[1]) * in_cell(oz + middle * dz - part.k));
    const Mask parted = lanes::mask(((s0 < zero) & (s1 > zero)) | ((s0 > zero) & (s1 < zero)));
    const Mask met = (below(first) & ~group.known) | (below(between) & parted) | below(last);
    const Mask out = cells & ~met;
    const Double before = xsimd::select(lanes::lanes_of(group.known), group.above.load(), first);
    if (const Mask found = cells & met & ~(below(first) & ~group.known); found != 0) {
        // TerrainWalk::edge(): between the last edge above it and the first below.
        const Mask early = parted & below(between);
        const Bool from_start = lanes::lanes_of(early | ~parted), to_middle = lanes::lanes_of(early);
        const Double t0 = xsimd::select(from_start, part.t, middle), t1 = xsimd::select(to_middle, middle, part.to),
                     h0 = xsimd::select(from_start, before, between), h1 = xsimd::select(to_middle, between, last);
        group.met_t.store(xsimd::select(lanes::lanes_of(found), t0 + (t1 - t0) * (h0 / (h0 - h1)), group.met_t.load()));
        const Mask upper = (early & lanes::mask(s0 > zero)) | (parted & ~early & lanes::mask(s1 > zero)) |
                           (~parted & lanes::mask(s0 + s1 > zero));
        group.found |= found;
        group.upper = (group.upper & ~found) | (upper & found);
    }
    group.above.store(xsimd::select(lanes::lanes_of(out), last, before));
    group.known |= out;
    return out;
}

/// Takes all that go past a block or cell, or into it: TerrainWalk::step().
inline void TerrainLanes::advance(Group& group) const
{
    const Double zero(0.0), one(1.0), four(4.0), quarter(0.25);
    const Double columns(static_cast<double>(field_.levels_[0].columns)),
        rows(static_cast<double>(field_.levels_[0].rows)), top(field_.levels_.back().size);
    const Double ox = group.ox.load(), oz = group.oz.load(), dx = group.dx.load(), dz = group.dz.load(),
                 right = group.right.load(), up = group.up.load(), end = group.end.load(), size = group.size.load(),
                 inverse = group.inverse.load(), row = group.row.load();
    Part part;
    part.t = group.t.load(), part.y = group.y.load(), part.i = group.i.load(), part.k = group.k.load();
    const Double &t = part.t, &i = part.i, &k = part.k, &to = part.to;
    const Double at_x = ((i + right) * size - ox) * group.ix.load(), at_z = ((k + up) * size - oz) * group.iz.load(),
                 edge = xsimd::min(at_x, at_z);
    part.to = xsimd::max(t, xsimd::min(edge, end));
    part.y_to = group.oy.load() + to * group.dy.load();
    const Mask cells = lanes::mask(size == one) & group.going;
    read(part, group, row, group.going & ~cells, cells);
    const Mask below = lanes::mask(xsimd::max(part.y, part.y_to) < part.low);
    Mask past = lanes::mask(xsimd::min(part.y, part.y_to) > part.high) & group.going;
    group.known &= ~past;
    if (const Mask asked = cells & ~past & ~below; asked != 0) past |= clear(group, part, asked);
    const Mask rest = group.going & ~past, met = rest & (cells | below), into = rest & ~met;
    // Past it: to the next of its size, or of the next larger.
    const Double deep = xsimd::ceil(rows * inverse);
    const Bool by_x = at_x <= at_z;
    const Double i_next = i + xsimd::select(by_x, right + right - one, zero),
                 k_next = k + xsimd::select(by_x, zero, up + up - one);
    const Double i_over = xsimd::floor(i_next * quarter), k_over = xsimd::floor(k_next * quarter);
    const Mask climb = past & lanes::mask(size < top) &
                       lanes::mask((i_over != xsimd::floor(i * quarter)) | (k_over != xsimd::floor(k * quarter)));
    const Bool leaves = (i_next < zero) | (k_next < zero) | (i_next >= xsimd::ceil(columns * inverse)) |
                        (k_next >= deep);
    const Mask ended = past & (~lanes::mask(edge < end) | lanes::mask((to > group.limit.load()) | leaves));
    // Into it.
    const Double finer = inverse * four, i_first = i * four, k_first = k * four;
    const Double deep_in = xsimd::ceil(rows * finer);
    const Double i_in = xsimd::trunc(xsimd::min(xsimd::max((ox + t * dx) * finer, i_first),
                                                xsimd::min(i_first + four, xsimd::ceil(columns * finer)) - one));
    const Double k_in =
        xsimd::trunc(xsimd::min(xsimd::max((oz + t * dz) * finer, k_first), xsimd::min(k_first + four, deep_in) - one));
    const Bool is_past = lanes::lanes_of(past), is_into = lanes::lanes_of(into), is_climb = lanes::lanes_of(climb);
    group.t.store(xsimd::select(is_past, to, t));
    group.y.store(xsimd::select(is_past, part.y_to, part.y));
    const auto place = [&](const Double& in, const Double& over, const Double& next, const Double& here) {
        return xsimd::select(is_into, in, xsimd::select(is_climb, over, xsimd::select(is_past, next, here)));
    };
    group.i.store(place(i_in, i_over, i_next, i));
    group.k.store(place(k_in, k_over, k_next, k));
    const auto level = [&](const Double& in, const Double& over, const Double& here) {
        return xsimd::select(is_into, in, xsimd::select(is_climb, over, here));
    };
    group.row.store(level(row - deep_in, row + deep, row));
    group.size.store(level(size * quarter, size * four, size));
    group.inverse.store(level(finer, inverse * quarter, inverse));
    group.met |= met;
    group.ended |= ended;
    group.going &= ~(met | ended);
}

#endif

void HeightField::intersect_many(std::span<const Ray> rays, IntersectionList* out) const
{
#if defined(__AVX2__)
    if (!empty()) TerrainLanes(*this, rays, out).run();
#else
    for (std::size_t k = 0; k < rays.size(); ++k) intersect(rays[k], out[k]);
#endif
}

}  // namespace csg
