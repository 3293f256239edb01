#include "csg/solids/shared/slab.h"
#include "csg/freeform/surface/terrain_walk.h"

namespace csg {

/// The part of the ray over the grid. Its end is the grid's, not the end of what is asked for: that depends on what the
/// ray has met before, and where the terrain is crossed is found between the ends of a step.
bool TerrainWalk::clip(double& first, double& last) const
{
    Interval column{.entry = out_.from, .exit = kInfinity}, side;
    if (!slab(ray_.origin.x, ray_.direction.x, 0.0, field_.scale_.x, side) || !narrow(column, side)) return false;
    if (!slab(ray_.origin.z, ray_.direction.z, 0.0, field_.scale_.z, side) || !narrow(column, side)) return false;
    first = column.entry;
    last = column.exit;
    return first <= out_.to;
}

void TerrainWalk::run()
{
    if (!start()) return;
    walk(first_place());
    finish();
}

/// What the ray meets before the band of levels in which the terrain lies. False: it has no part there.
bool TerrainWalk::start()
{
    double first = 0.0;
    const double down = ray_.direction.y, height = ray_.origin.y;
    if (!clip(first, last_)) return false;
    if (field_.floor_ > field_.top_) {  // all of it under water
        Interval over{.entry = first, .exit = std::min(last_, out_.to)}, below;
        if (!slab(height, down, -kInfinity, field_.floor_, below) || !narrow(over, below)) return false;
        if (out_.enter(over.entry, kUndrawnFace)) out_.leave(over.exit, kUndrawnFace);
        return false;
    }
    if (down == 0.0 && !(height <= field_.top_)) return false;
    // Between low and high the ray is in the band.
    double low = -kInfinity, high = kInfinity;
    if (down != 0.0) {
        const double a = (field_.floor_ - height) / down, b = (field_.top_ - height) / down;
        low = std::min(a, b);
        high = std::max(a, b);
    } else if (height < field_.floor_) {
        low = kInfinity;
    }
    if ((down > 0.0 && first < low) || (down < 0.0 && first > high) || low == kInfinity) cross(first, kUndrawnFace);
    begin_ = std::max(first, low);
    end_ = std::min(last_, high);
    if (begin_ <= end_ && begin_ > -kInfinity && end_ < kInfinity) {
        through_ = end_ == high;
        enter_band(begin_, first < low);
        return true;
    }
    leave_grid();
    return false;
}

/// What it meets beyond.
void TerrainWalk::finish()
{
    if (!done_ && through_ && end_ <= out_.to) leave_band(end_, ray_.direction.y < 0.0);
    leave_grid();
}

/// Which side of the terrain the ray is on where it comes into the band at t, through its floor or top (`from_beyond`)
/// or a side. Sides are not drawn, nor is the water: a hole. Without one, what changes at the floor is terrain that
/// rounding has moved.
void TerrainWalk::enter_band(double t, bool from_beyond)
{
    // No corner is as high: there is no need to look.
    if (y(t) > field_.top_ - HeightField::kMargin / 2.0) {
        if (inside_) cross(t, from_beyond && !field_.hole_ ? face_below(t) : kUndrawnFace);
        return;
    }
    const std::uint32_t i = place(x(t), 0, field_.grid_.columns - 1), k = place(z(t), 0, field_.grid_.rows - 1);
    const double across = std::clamp(x(t) - i, 0.0, 1.0), along = std::clamp(z(t) - k, 0.0, 1.0);
    const bool inside = y(t) < terrain_level(field_.corners(i, k), across, along);
    if (inside != inside_) cross(t, from_beyond && !field_.hole_ ? face_below(t) : kUndrawnFace);
}

/// At the floor or the top there is one side alone.
void TerrainWalk::leave_band(double t, bool inside)
{
    if (inside != inside_) cross(t, field_.hole_ ? kUndrawnFace : face_below(t));
}

/// Whether a step is all above or all below the levels of what it passes over.
inline bool TerrainWalk::passed(HeightField::Range range, const Step& step)
{
    if (step.lowest() > range.highest) settle(false, step.from);
    else if (step.highest() < range.lowest) settle(true, step.from);
    else return false;
    return true;
}

/// Into the block of the next lower level that the ray is over.
inline void TerrainWalk::descend(Place& at) const
{
    const HeightField::Level& level = field_.levels_[--at.level];
    const double inverse = 1.0 / level.size;
    const std::int32_t i = at.i * kWide, k = at.k * kWide;
    at.i = nearest(x(at.t) * inverse, i, std::min(i + kWide, level.columns) - 1);
    at.k = nearest(z(at.t) * inverse, k, std::min(k + kWide, level.rows) - 1);
}

TerrainWalk::Place TerrainWalk::first_place() const
{
    const HeightField::Level& top = field_.levels_.back();
    return {field_.levels_.size() - 1, nearest(x(begin_) / top.size, 0, top.columns - 1),
            nearest(z(begin_) / top.size, 0, top.rows - 1), begin_, y(begin_)};
}

void TerrainWalk::walk(Place at)
{
    while (!(at.t > out_.to) && step(at)) {}
}

/// Past the block or cell, or into it. False: there is no more to come. TerrainLanes::advance() does the same with the
/// same numbers; of numbers that are none the same is taken as there.
bool TerrainWalk::step(Place& at)
{
    const glm::dvec3 &o = ray_.origin, &d = ray_.direction;
    const bool right = d.x > 0.0, up = d.z > 0.0;
    const HeightField::Level& level = field_.levels_[at.level];
    const double at_x = d.x != 0.0 ? ((at.i + (right ? 1 : 0)) * level.size - o.x) * inverse_.x : kInfinity,
                 at_z = d.z != 0.0 ? ((at.k + (up ? 1 : 0)) * level.size - o.z) * inverse_.z : kInfinity,
                 edge = std::min(at_z, at_x);
    Step part{at.t, std::max(at.t, std::min(end_, edge)), at.y, 0.0};
    part.y_to = y(part.to);
    if (!passed(at.level == 0 ? field_.cell_range(at.i, at.k) : field_.block_range(level, at.i, at.k), part)) {
        if (at.level != 0) {
            descend(at);
            return true;
        }
        triangles(static_cast<std::uint32_t>(at.i), static_cast<std::uint32_t>(at.k), part);
    }
    if (done_ || !(edge < end_)) return false;
    at.t = part.to;
    at.y = part.y_to;
    std::int32_t &by = at_x <= at_z ? at.i : at.k, was = by;
    by += at_x <= at_z ? (right ? 1 : -1) : (up ? 1 : -1);
    if (at.i < 0 || at.k < 0 || at.i == level.columns || at.k == level.rows) return false;
    if ((was ^ by) >> kWideBits != 0 && at.level + 1 < field_.levels_.size()) {
        at.i >>= kWideBits;
        at.k >>= kWideBits;
        ++at.level;
    }
    return true;
}

/// The ray has come to t, so far above the terrain, through the triangle `face`.
void TerrainWalk::edge(double t, double above, std::uint32_t face)
{
    if ((above < 0.0) != inside_) {
        const bool between = known_ && (above_ < 0.0) != (above < 0.0);
        cross(between ? t_ + (t - t_) * (above_ / (above_ - above)) : known_ ? t_ : t, face);
    }
    t_ = t;
    above_ = above;
    known_ = true;
}

void TerrainWalk::triangles(std::uint32_t i, std::uint32_t k, const Step& step)
{
    const std::array<double, 4> h = field_.corners(i, k);
    const auto in_cell = [](double v, std::uint32_t first) { return std::clamp(v - first, 0.0, 1.0); };
    const double x0 = in_cell(x(step.from), i), z0 = in_cell(z(step.from), k), x1 = in_cell(x(step.to), i),
                 z1 = in_cell(z(step.to), k);
    const double s0 = x0 + z0 - 1.0, s1 = x1 + z1 - 1.0;
    if (!known_) edge(step.from, step.y_from - terrain_level(h, x0, z0), face_of(i, k, s0 > 0.0));
    if (done_) return;
    const bool parted = (s0 < 0.0 && s1 > 0.0) || (s0 > 0.0 && s1 < 0.0);
    if (parted) {
        const double t = step.from + (step.to - step.from) * (s0 / (s0 - s1));
        edge(t, y(t) - (h[1] + (h[2] - h[1]) * in_cell(z(t), k)), face_of(i, k, s0 > 0.0));
        if (done_) return;
    }
    edge(step.to, step.y_to - terrain_level(h, x1, z1), face_of(i, k, parted ? s1 > 0.0 : s0 + s1 > 0.0));
}

}  // namespace csg
