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
    double first = 0.0, last = 0.0;
    const double down = ray_.direction.y, height = ray_.origin.y;
    if (!clip(first, last)) return;
    if (field_.floor_ > field_.top_) {  // all of it under water
        Interval over{.entry = first, .exit = std::min(last, out_.to)}, below;
        if (!slab(height, down, -kInfinity, field_.floor_, below) || !narrow(over, below)) return;
        if (out_.enter(over.entry, kUndrawnFace)) out_.leave(over.exit, kUndrawnFace);
        return;
    }
    if (down == 0.0 && !(height <= field_.top_)) return;
    // Between low and high the ray is in the band of levels in which the terrain lies.
    double low = -kInfinity, high = kInfinity;
    if (down != 0.0) {
        const double a = (field_.floor_ - height) / down, b = (field_.top_ - height) / down;
        low = std::min(a, b);
        high = std::max(a, b);
    } else if (height < field_.floor_) {
        low = kInfinity;
    }
    if ((down > 0.0 && first < low) || (down < 0.0 && first > high) || low == kInfinity) cross(first, kUndrawnFace);
    const double begin = std::max(first, low), end = std::min(last, high);
    if (begin <= end && begin > -kInfinity && end < kInfinity) {
        enter_band(begin, first < low);
        const HeightField::Blocks& all = field_.blocks_.back();
        walk(field_.blocks_.size(), {0, all.columns, 0, all.rows}, begin, end);
        if (!done_ && end == high && end <= out_.to) leave_band(end, down < 0.0);
    }
    if (inside_ && !done_) out_.leave(std::min(last, out_.to), kUndrawnFace);
}

/// Which side of the terrain the ray is on where it comes into the band at t, through its floor or top (`from_beyond`)
/// or a side. Sides are not drawn, nor is the water: a hole. Without one, what changes at the floor is terrain that
/// rounding has moved.
void TerrainWalk::enter_band(double t, bool from_beyond)
{
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

inline void TerrainWalk::cell(std::uint32_t i, std::uint32_t k, const Step& step)
{
    const std::uint16_t *low = &field_.grid_.levels[std::size_t{k} * field_.grid_.columns + i],
                        *high = low + field_.grid_.columns;
    if (step.lowest() > std::max(std::max(low[0], low[1]), std::max(high[0], high[1]))) return settle(false, step.from);
    if (step.highest() < std::min(std::min(low[0], low[1]), std::min(high[0], high[1]))) return settle(true, step.from);
    triangles(i, k, step);
}

/// `level` 0: cells; blocks otherwise.
void TerrainWalk::walk(std::size_t level, const Window& window, double from, double to)
{
    const double size = static_cast<double>(std::uint32_t{1} << (level * kWideBits)), inverse_size = 1.0 / size;
    const glm::dvec3 &o = ray_.origin, &d = ray_.direction;
    std::uint32_t i = place(x(from) * inverse_size, window.x_from, window.x_to),
                  k = place(z(from) * inverse_size, window.z_from, window.z_to);
    const bool right = d.x > 0.0, up = d.z > 0.0;
    const auto next_x = [&] { return d.x != 0.0 ? ((i + (right ? 1u : 0u)) * size - o.x) * inverse_.x : kInfinity; };
    const auto next_z = [&] { return d.z != 0.0 ? ((k + (up ? 1u : 0u)) * size - o.z) * inverse_.z : kInfinity; };
    double at_x = next_x(), at_z = next_z();
    Step step{from, from, y(from), y(from)};
    while (!done_) {
        const bool by_x = at_x <= at_z;
        const double edge = by_x ? at_x : at_z;
        step.from = step.to;
        step.y_from = step.y_to;
        if (step.from > out_.to) return;
        step.to = std::max(step.from, std::min(edge, to));
        step.y_to = y(step.to);
        if (level == 0) cell(i, k, step);
        else block(level, i, k, step);
        if (!(edge < to)) return;
        if (by_x) {
            if (right ? ++i == window.x_to : i-- == window.x_from) return;
            at_x = next_x();
        } else {
            if (up ? ++k == window.z_to : k-- == window.z_from) return;
            at_z = next_z();
        }
    }
}

void TerrainWalk::block(std::size_t level, std::uint32_t i, std::uint32_t k, const Step& step)
{
    const HeightField::Blocks& blocks = field_.blocks_[level - 1];
    const HeightField::Range range = blocks.ranges[std::size_t{k} * blocks.columns + i];
    if (step.lowest() > range.highest) return settle(false, step.from);
    if (step.highest() < range.lowest) return settle(true, step.from);
    const std::uint32_t columns = level == 1 ? field_.grid_.columns - 1 : field_.blocks_[level - 2].columns;
    const std::uint32_t rows = level == 1 ? field_.grid_.rows - 1 : field_.blocks_[level - 2].rows;
    walk(level - 1, {i * kWide, std::min((i + 1) * kWide, columns), k * kWide, std::min((k + 1) * kWide, rows)},
         step.from, step.to);
}

/// The ray has come to t, so far above the terrain, through the triangle `face`.
void TerrainWalk::edge(double t, double above, std::uint32_t face)
{
    if ((above < 0.0) != inside_) {
        const bool between = known_ && (above_ < 0.0) != (above < 0.0);
        cross(between ? t_ + (t - t_) * (above_ / (above_ - above)) : t_, face);
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
