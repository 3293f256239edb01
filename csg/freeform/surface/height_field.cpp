#include "csg/freeform/surface/height_field.h"

#include "csg/freeform/surface/terrain_walk.h"

namespace csg {
namespace {

/// The box of what is drawn is this much higher and lower than the points, in levels (spec 5b, 10.2).
constexpr double kMargin = 0.001;
constexpr double kLevels = 65536.0;

std::uint32_t above(std::uint32_t n, std::uint32_t by) { return (n + by - 1) / by; }

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
    constexpr std::uint32_t kWide = TerrainWalk::kWide;
    std::uint32_t columns = grid_.columns - 1, rows = grid_.rows - 1;
    do {
        Blocks made{above(columns, kWide), above(rows, kWide), {}};
        made.ranges.resize(std::size_t{made.columns} * made.rows);
        const auto add = [&](Range& range, const Range& more) {
            range.lowest = std::min(range.lowest, more.lowest);
            range.highest = std::max(range.highest, more.highest);
        };
        if (blocks_.empty()) {
            // A point on a border between blocks belongs to both.
            for (std::uint32_t k = 0; k <= rows; ++k)
                for (std::uint32_t i = 0; i <= columns; ++i) {
                    const std::uint16_t level = grid_.levels[std::size_t{k} * grid_.columns + i];
                    for (std::uint32_t b = (k > 0 ? k - 1 : 0) / kWide; b <= std::min(k, rows - 1) / kWide; ++b)
                        for (std::uint32_t a = (i > 0 ? i - 1 : 0) / kWide; a <= std::min(i, columns - 1) / kWide; ++a)
                            add(made.ranges[std::size_t{b} * made.columns + a], {level, level});
                }
        } else {
            for (std::uint32_t k = 0; k < rows; ++k)
                for (std::uint32_t i = 0; i < columns; ++i)
                    add(made.ranges[std::size_t{k / kWide} * made.columns + i / kWide],
                        blocks_.back().ranges[std::size_t{k} * columns + i]);
        }
        columns = made.columns;
        rows = made.rows;
        blocks_.push_back(std::move(made));
    } while (columns > kWide || rows > kWide);
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

/// The sum of the unit normals that a point has with its neighbours in each quadrant, as POV-Ray stores it: the steps
/// of 16 bits are seen, for in levels all slopes are steep.
glm::dvec3 HeightField::point_normal(std::uint32_t i, std::uint32_t k) const
{
    const double here = level(i, k);
    glm::dvec3 sum(0.0);
    for (const int across : {-1, 1})
        for (const int along : {-1, 1}) {
            if ((across < 0 && i == 0) || (across > 0 && i + 1 == grid_.columns)) continue;
            if ((along < 0 && k == 0) || (along > 0 && k + 1 == grid_.rows)) continue;
            const std::uint32_t a = across < 0 ? i - 1 : i + 1, b = along < 0 ? k - 1 : k + 1;
            sum += glm::normalize(glm::dvec3(across * (here - level(a, k)), 1.0, along * (here - level(i, b))));
        }
    return glm::trunc(32767.0 * glm::normalize(sum));
}

glm::dvec3 HeightField::world_gradient(const Transform& frame, const glm::dvec3& p, std::uint32_t face) const
{
    if (!grid_.smooth) return frame.normal(gradient(p, face));
    const std::uint32_t cell = face / 2, wide = grid_.columns - 1, i = cell % wide, k = cell / wide;
    const double fx = std::clamp(p.x * scale_.x - i, 0.0, 1.0), fz = std::clamp(p.z * scale_.z - k, 0.0, 1.0);
    const auto at = [&](std::uint32_t a, std::uint32_t b) {
        return unit_or_x(frame.normal(point_normal(a, b) * scale_));
    };
    return (1.0 - fz) * ((1.0 - fx) * at(i, k) + fx * at(i + 1, k)) +
           fz * ((1.0 - fx) * at(i, k + 1) + fx * at(i + 1, k + 1));
}

Aabb HeightField::extent() const
{
    if (empty() || floor_ > top_) return {};
    return {{0.0, floor_ / kLevels, 0.0}, {1.0, top_ / kLevels, 1.0}};
}

std::size_t HeightField::bytes() const
{
    std::size_t sum = grid_.levels.capacity() * sizeof(std::uint16_t);
    for (const Blocks& b : blocks_) sum += b.ranges.capacity() * sizeof(Range);
    return sum;
}

}  // namespace csg
