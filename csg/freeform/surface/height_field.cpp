#include "csg/freeform/surface/height_field.h"

#include "csg/freeform/surface/terrain_walk.h"

namespace csg {
namespace {

constexpr double kLevels = 65536.0;

std::int32_t above(std::int32_t n, std::int32_t by) { return (n + by - 1) / by; }

/// The cell that a coordinate lies in; what is not inside belongs to the nearest.
std::uint32_t cell_at(double x, std::uint32_t points)
{
    return static_cast<std::uint32_t>(std::clamp(std::floor(x), 0.0, static_cast<double>(points - 2)));
}

}  // namespace

HeightField::HeightField(Grid grid) : grid_(std::move(grid))
{
    if (empty() || grid_.levels.size() != std::size_t{grid_.columns} * grid_.rows) {
        grid_ = {};
        return;
    }
    const auto [lowest, highest] = std::minmax_element(grid_.levels.begin(), grid_.levels.end());
    scale_ = {static_cast<double>(grid_.columns - 1), kLevels, static_cast<double>(grid_.rows - 1)};
    hole_ = grid_.water > *lowest;
    floor_ = std::max<double>(*lowest, grid_.water) - kMargin;
    top_ = *highest + kMargin;
    build_blocks();
}

void HeightField::build_blocks()
{
    constexpr std::int32_t kWide = TerrainWalk::kWide, kWidestTop = 8;
    const auto add = [](Range& range, const Range& more) {
        range.lowest = std::min(range.lowest, more.lowest);
        range.highest = std::max(range.highest, more.highest);
    };
    levels_.push_back({static_cast<std::int32_t>(grid_.columns - 1), static_cast<std::int32_t>(grid_.rows - 1), 0});
    std::uint32_t row = 0;
    do {
        const Level below = levels_.back();
        const Level made{above(below.columns, kWide), above(below.rows, kWide), row, below.size * kWide};
        row += static_cast<std::uint32_t>(made.rows);
        levels_.push_back(made);
        ranges_.resize(std::size_t{row} * static_cast<std::size_t>(levels_[1].columns));
        for (std::int32_t k = 0; k < below.rows; ++k)
            for (std::int32_t i = 0; i < below.columns; ++i)
                add(ranges_[at(made, i / kWide, k / kWide)],
                    levels_.size() == 2 ? cell_range(i, k) : block_range(below, i, k));
    } while (levels_.back().columns > kWidestTop || levels_.back().rows > kWidestTop);
}

void HeightField::intersect(const Ray& ray, IntersectionList& out) const
{
    if (!empty()) TerrainWalk(*this, {ray.origin * scale_, ray.direction * scale_}, out).run();
}

bool HeightField::contains(const glm::dvec3& p) const
{
    if (empty()) return false;
    const glm::dvec3 q = p * scale_;
    if (!(q.x >= 0.0 && q.x < scale_.x && q.z >= 0.0 && q.z < scale_.z && q.y < top_)) return false;
    if (q.y < floor_) return true;
    const std::uint32_t i = cell_at(q.x, grid_.columns), k = cell_at(q.z, grid_.rows);
    std::array<double, 4> h = corners(i, k);
    for (double& level : h) level = std::max(level, grid_.water);
    return q.y < terrain_level(h, q.x - i, q.z - k);
}

glm::dvec3 HeightField::gradient(const glm::dvec3&, std::uint32_t face) const
{
    const std::uint32_t cell = face / 2, wide = grid_.columns - 1;
    const auto [h00, h10, h01, h11] = corners(cell % wide, cell / wide);
    const glm::dvec3 n = face % 2 == 0 ? glm::dvec3(h00 - h10, 1.0, h00 - h01) : glm::dvec3(h01 - h11, 1.0, h10 - h11);
    return n * scale_;
}

/// Of a cell's corners the sums of the unit normals that each has with its neighbours in each quadrant, as POV-Ray
/// stores them: the steps of 16 bits are seen, for in levels all slopes are steep.
HeightField::Corners HeightField::corner_normals(std::uint32_t i, std::uint32_t k) const
{
    // Quadrant q of corner c is 4 c + q. All roots stand in one loop, for the vector unit.
    std::array<double, 16> across, along, length;
    for (std::uint32_t c = 0; c < 4; ++c) {
        const std::uint32_t a = i + c % 2, b = k + c / 2;
        const bool there[4] = {a != 0, a + 1 != grid_.columns, b != 0, b + 1 != grid_.rows};
        const double here = level(a, b);
        const double left = there[0] ? level(a - 1, b) - here : 0.0, right = there[1] ? here - level(a + 1, b) : 0.0,
                     near = there[2] ? level(a, b - 1) - here : 0.0, far = there[3] ? here - level(a, b + 1) : 0.0;
        for (std::uint32_t q = 0; q < 4; ++q) {
            across[4 * c + q] = q < 2 ? left : right;
            along[4 * c + q] = q % 2 == 0 ? near : far;
            length[4 * c + q] = there[q / 2] && there[2 + q % 2] ? 1.0 : 0.0;  // nothing is added for a missing one
        }
    }
    for (std::size_t n = 0; n < 16; ++n)
        length[n] = length[n] / std::sqrt(across[n] * across[n] + 1.0 + along[n] * along[n]);
    for (std::size_t n = 0; n < 16; ++n) {
        across[n] *= length[n];
        along[n] *= length[n];
    }
    std::array<double, 4> x, y, z;
    for (std::size_t c = 0; c < 4; ++c) {
        x[c] = across[4 * c] + across[4 * c + 1] + across[4 * c + 2] + across[4 * c + 3];
        y[c] = length[4 * c] + length[4 * c + 1] + length[4 * c + 2] + length[4 * c + 3];
        z[c] = along[4 * c] + along[4 * c + 1] + along[4 * c + 2] + along[4 * c + 3];
    }
    for (std::size_t c = 0; c < 4; ++c) {
        const double one = 1.0 / std::sqrt(x[c] * x[c] + y[c] * y[c] + z[c] * z[c]);
        x[c] = 32767.0 * (x[c] * one);
        y[c] = 32767.0 * (y[c] * one);
        z[c] = 32767.0 * (z[c] * one);
    }
    Corners out;
    for (std::size_t c = 0; c < 4; ++c) out[c] = glm::trunc(glm::dvec3(x[c], y[c], z[c]));
    return out;
}

HeightField::Corners HeightField::world_corners(const Transform& frame, std::uint32_t cell) const
{
    const std::uint32_t wide = grid_.columns - 1;
    Corners n = corner_normals(cell % wide, cell / wide);
    for (glm::dvec3& corner : n) corner = unit_or_x(frame.normal(corner * scale_));
    return n;
}

glm::dvec3 HeightField::blended(const Corners& n, const glm::dvec3& p, std::uint32_t cell) const
{
    const std::uint32_t wide = grid_.columns - 1;
    const double fx = std::clamp(p.x * scale_.x - cell % wide, 0.0, 1.0),
                 fz = std::clamp(p.z * scale_.z - cell / wide, 0.0, 1.0);
    return (1.0 - fz) * ((1.0 - fx) * n[0] + fx * n[1]) + fz * ((1.0 - fx) * n[2] + fx * n[3]);
}

glm::dvec3 HeightField::world_gradient(const Transform& frame, const glm::dvec3& p, std::uint32_t face) const
{
    if (!grid_.smooth) return frame.normal(gradient(p, face));
    return blended(world_corners(frame, face / 2), p, face / 2);
}

void HeightField::world_gradients(const Transform& frame, std::span<const glm::dvec3> points,
                                  std::span<const std::uint32_t> faces, glm::dvec3* out) const
{
    if (!grid_.smooth) {
        for (std::size_t i = 0; i < points.size(); ++i) out[i] = frame.normal(gradient(points[i], faces[i]));
        return;
    }
    // In pictures of many pixels a tile of rays meets few cells.
    struct Known {
        std::uint32_t cell = ~std::uint32_t{0};  // above all cells
        Corners corners;
    };
    constexpr std::uint32_t kSide = 4;  // neighbours have places of their own
    std::array<Known, kSide * kSide> known;
    const std::uint32_t wide = grid_.columns - 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t cell = faces[i] / 2;
        Known& at = known[cell / wide % kSide * kSide + cell % wide % kSide];
        if (at.cell != cell) at = {cell, world_corners(frame, cell)};
        out[i] = blended(at.corners, points[i], cell);
    }
}

Aabb HeightField::extent() const
{
    if (empty() || floor_ > top_) return {};
    return {{0.0, floor_ / kLevels, 0.0}, {1.0, top_ / kLevels, 1.0}};
}

Aabb HeightField::space() const
{
    if (empty()) return {};
    return {{0.0, -kInfinity, 0.0}, {1.0, top_ / kLevels, 1.0}};
}

std::size_t HeightField::bytes() const
{
    return grid_.levels.capacity() * sizeof(std::uint16_t) + ranges_.capacity() * sizeof(Range);
}

}  // namespace csg
