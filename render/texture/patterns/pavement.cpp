#include "numbers/rounding.h"
#include "render/texture/patterns/patterns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

/// Polyominoes, polyiamonds and polyhexes on a grid of squares or triangles (spec 4, section 7). Every cell knows which
/// of its sides are walls of a tile and where the tile has a re-entrant corner.
namespace texture {
namespace {

enum class Numbering : std::uint8_t { Rows, Skewed, Columns };

struct PavementRule {
    int sides, tiles, pattern;
    Numbering numbering;
    int m, a, p, c;
    std::size_t first_cell;
};
constexpr PavementRule kPavements[] = {
#include "render/texture/patterns/pavements.inc"
};
constexpr std::uint16_t kPavementCells[] = {
#include "render/texture/patterns/pavement_cells.inc"
};

constexpr int kMostTiles = 6, kMostPatterns = 35;

/// Where the rule of (sides, tiles, pattern) stands in kPavements.
constexpr auto kRulePlaces = [] {
    std::array<std::uint8_t, 7 * (kMostTiles + 1) * (kMostPatterns + 1)> places{};
    for (std::size_t i = 0; i < std::size(kPavements); ++i) {
        const PavementRule& rule = kPavements[i];
        places[static_cast<std::size_t>((rule.sides * (kMostTiles + 1) + rule.tiles) * (kMostPatterns + 1) +
                                        rule.pattern)] = static_cast<std::uint8_t>(i);
    }
    return places;
}();

long long floor_division(long long v, long long by) { return (v >= 0 ? v : v - by + 1) / by; }
long long positive_remainder(long long v, long long by) { return v - by * floor_division(v, by); }

/// The cell with the coordinates (i, j): its flags.
unsigned cell_flags(const PavementRule& rule, double column, double row)
{
    const auto i = numbers::truncated_far(column), j = numbers::truncated_far(row);
    long long index = 0;
    switch (rule.numbering) {
    case Numbering::Rows:
        index = positive_remainder(i + rule.a * floor_division(j, rule.p), rule.m) +
                rule.m * positive_remainder(j, rule.p);
        break;
    case Numbering::Skewed:
        index = positive_remainder(i + rule.a * j, rule.m) + rule.m * positive_remainder(j, rule.p);
        break;
    case Numbering::Columns:
        index = positive_remainder(i, rule.m) +
                rule.m * positive_remainder(j + rule.a * (positive_remainder(i, rule.c) / rule.m), rule.p);
        break;
    }
    return kPavementCells[rule.first_cell + static_cast<std::size_t>(index)];
}

bool flag(unsigned flags, std::size_t bit) { return flags >> bit & 1u; }
/// `value` as one of 0, 1, ..., count - 1.
int choice(double value, int count)
{
    return static_cast<int>(positive_remainder(numbers::truncated_far(value), count));
}

/// Greatest, summed or straight distance.
double norm(int kind, double a, double b)
{
    if (kind == 0) return std::max(a, b);
    return kind == 1 ? a + b : std::sqrt(a * a + b * b);
}

double square_pavement(const PavementRule& rule, const Pattern& pattern, double x, double z)
{
    // Walls are bits 0 to 3 (+z, +x, -z, -x), corners 4 to 7 (-x+z, +x+z, +x-z, -x-z).
    static constexpr std::array<std::array<std::size_t, 2>, 4> kBeside{{{0, 3}, {0, 1}, {2, 1}, {2, 3}}},
        kAcross{{{1, 2}, {2, 3}, {0, 3}, {0, 1}}};
    const double column = std::floor(x), row = std::floor(z);
    const double u = 2.0 * (x - column) - 1.0, w = 2.0 * (z - row) - 1.0;
    const unsigned flags = cell_flags(rule, column, row);
    const std::array<double, 4> toward{w, u, -w, -u};
    // Twice the distances from a corner along x and z.
    const auto to_corner = [&](std::size_t corner, int kind) {
        return norm(kind, 1.0 - toward[kBeside[corner][1]], 1.0 - toward[kBeside[corner][0]]);
    };
    const int exterior = choice(pattern.numbers[3], 3), interior = choice(pattern.numbers[4], 3),
              form = choice(pattern.numbers[5], 4);

    if (form < 3)
        for (std::size_t c = 0; c < 4; ++c)
            if (flag(flags, 4 + c) && flag(flags, kAcross[c][0]) && flag(flags, kAcross[c][1]))
                return std::min(std::abs(to_corner(c, form) - 1.0), 1.0);
    double v = 0.0;
    for (std::size_t wall = 0; wall < 4; ++wall)
        if (flag(flags, wall)) v = std::max(v, toward[wall]);
    for (std::size_t c = 0; c < 4; ++c)
        if (flag(flags, 4 + c)) v = std::max(v, 1.0 - to_corner(c, interior));
    if (exterior != 0)
        for (std::size_t c = 0; c < 4; ++c) {
            if (!flag(flags, kBeside[c][0]) || !flag(flags, kBeside[c][1])) continue;
            const double e = toward[kBeside[c][0]], f = toward[kBeside[c][1]];
            if (exterior == 1) v = std::max(v, std::min(1.0, e + f));
            else if (e >= 0.0 && f >= 0.0) v = std::max(v, std::min(1.0, std::sqrt(e * e + f * f)));
        }
    return v;
}

const double kRoot3 = std::sqrt(3.0);

/// A cell of the grid of triangles and the point in it, as if its left corner were the origin and its top upward.
struct TriangleCell {
    double column, row;
    glm::dvec2 at;
};
TriangleCell triangle_cell(double x, double z)
{
    const double height = kRoot3 / 2.0;
    const double row = std::floor(z / height), up = z - row * height;
    const double shift = positive_remainder(numbers::truncated_far(row), 2) ? 0.5 : 0.0;
    const double corner = std::floor(x - shift), across = x - shift - corner, column = 2.0 * (corner + shift);
    // A downward triangle is the upward one turned about the middle of their common side.
    if (across == 0.0 || up > kRoot3 * across) return {column - 1.0, row, {0.5 - across, height - up}};
    if (up > kRoot3 * (1.0 - across)) return {column + 1.0, row, {0.5 - (across - 1.0), height - up}};
    return {column, row, {across, up}};
}

/// Corners in the order apex, left, right.
const std::array<glm::dvec2, 3> kCorners{{{0.5, kRoot3 / 2.0}, {0.0, 0.0}, {1.0, 0.0}}};
const glm::dvec2 kCentroid(0.5, kRoot3 / 6.0);

/// Which corner is nearest; edges of the regions belong to none, unless `closed`.
bool in_region(std::size_t corner, const glm::dvec2& p, bool closed)
{
    const double a = 1.0 - (p.x + kRoot3 * p.y), b = 1.0 - (kRoot3 * p.y - p.x + 1.0), c = 1.0 - 2.0 * p.x;
    const auto positive = [closed](double v) { return closed ? v >= 0.0 : v > 0.0; };
    if (corner == 0) return positive(-a) && positive(-b);
    return corner == 1 ? positive(a) && positive(c) : positive(-c) && positive(b);
}

double triangle_interior(int interior, std::size_t corner, const glm::dvec2& p)
{
    const glm::dvec2 delta = p - kCorners[corner];
    if (interior == 0) return 1.0 - 2.0 * kRoot3 * glm::dot(delta, glm::normalize(kCentroid - kCorners[corner]));
    if (interior == 2) return 1.0 - 3.0 * glm::length(delta);
    if (!in_region(corner, p, false)) return 0.0;
    double along = -1e30;
    for (std::size_t other = 0; other < 3; ++other)
        if (other != corner) along = std::max(along, glm::dot(delta, kCorners[other] - kCorners[corner]));
    return 1.0 - 3.0 * along;
}

double triangle_pavement(const PavementRule& rule, const Pattern& pattern, double x, double z)
{
    const TriangleCell cell = triangle_cell(x, z);
    const unsigned flags = cell_flags(rule, cell.column, cell.row);
    const glm::dvec2& p = cell.at;
    const int exterior = choice(pattern.numbers[3], 3), interior = choice(pattern.numbers[4], 3),
              form = choice(pattern.numbers[5], 3);
    const double inverse_radius = 2.0 * kRoot3;
    // Walls left, right, bottom.
    const std::array<double, 3> shade{1.0 - inverse_radius * (kRoot3 * p.x - p.y) / 2.0,
                                      1.0 - inverse_radius * (kRoot3 * (1.0 - p.x) - p.y) / 2.0,
                                      1.0 - inverse_radius * p.y};
    if (form != 0) {
        // K about O: a tile turns at O, and the region of K shows it.
        static constexpr std::array<std::array<std::size_t, 2>, 6> kAbout{
            {{0, 1}, {1, 0}, {0, 2}, {2, 0}, {1, 2}, {2, 1}}};
        for (std::size_t f = 0; f < 6; ++f) {
            const auto [corner, about] = kAbout[f];
            if (!flag(flags, 6 + f) || !in_region(corner, p, false)) continue;
            const glm::dvec2 toward = kCorners[corner] - kCorners[about], delta = p - kCorners[about];
            if (form == 1) return std::min(1.0, 4.0 * (glm::dot(delta, toward) - 0.5));
            return std::clamp(inverse_radius * (glm::length(delta) - kRoot3 / 3.0), 0.0, 1.0);
        }
    }
    double v = 0.0;
    for (std::size_t wall = 0; wall < 3; ++wall)
        if (flag(flags, wall)) v = std::max(v, shade[wall]);
    for (std::size_t corner = 0; corner < 3; ++corner)
        if (flag(flags, 3 + corner)) v = std::max(v, triangle_interior(interior, corner, p));
    if (rule.sides != 3 || exterior == 0) return v;
    static constexpr std::array<std::array<std::size_t, 3>, 3> kSharp{
        {{0, 0, 1}, {2, 1, 2}, {1, 0, 2}}};  // corner, its two walls
    for (const auto& [corner, one, other] : kSharp) {
        if (!flag(flags, one) || !flag(flags, other)) continue;
        const glm::dvec2 g = p - kCentroid;
        if (exterior == 1 && shade[one] >= 0.0 && shade[other] >= 0.0)
            v = std::min(1.0, inverse_radius * std::abs(glm::dot(g, glm::normalize(kCorners[corner] - kCentroid))));
        if (exterior == 2 && in_region(corner, p, true)) v = std::min(1.0, inverse_radius * glm::length(g));
    }
    return v;
}

}  // namespace

double pavement(const Pattern& pattern, const glm::dvec3& p)
{
    if (!std::isfinite(p.x + p.z)) return 0.0;  // a warp's singular point
    const auto& n = pattern.numbers;
    const auto place = static_cast<std::size_t>((static_cast<int>(n[0]) * (kMostTiles + 1) + static_cast<int>(n[1])) *
                                                    (kMostPatterns + 1) +
                                                static_cast<int>(n[2]));
    const PavementRule& rule = kPavements[kRulePlaces[place]];
    return rule.sides == 4 ? square_pavement(rule, pattern, p.x, p.z) : triangle_pavement(rule, pattern, p.x, p.z);
}

}  // namespace texture
