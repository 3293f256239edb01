#include "render/texture/patterns/patterns.h"
#include "render/texture/patterns/penrose.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace texture {
namespace {

/// As tilings.inc writes it.
struct WrittenPolygon {
    double value;         ///< of its class, some with a tiny offset
    double least;         ///< the value with its shade is at least this
    unsigned wide_edges;  ///< a bit each: the radius is 1/3 (a flaw of POV-Ray's dodecagon in tiling 22)
    std::vector<glm::dvec2> corners;
};
struct WrittenTiling {
    int classes;
    double radius;             ///< distance from an edge where its shade ends
    glm::dvec2 first, second;  ///< the lattice
    std::vector<WrittenPolygon> polygons;
};

struct TileEdge {
    glm::dvec2 inward;  ///< unit
    double offset, radius;
    double distance(const glm::dvec2& q) const { return glm::dot(inward, q) - offset; }
};
struct Tile {
    double value, least;
    std::vector<TileEdge> edges;
    /// How deep `q` lies in the tile: negative outside.
    double depth(const glm::dvec2& q) const
    {
        double d = edges.front().distance(q);
        for (const TileEdge& edge : edges) d = std::min(d, edge.distance(q));
        return d;
    }
};

/// Sides of the grid over the fundamental cell: each square knows the tiles that it may meet, two or three of them.
constexpr int kGrid = 12;

struct ReadyTiling {
    double classes = 1;
    glm::dvec2 first{1, 0}, second{0, 1}, along_first{1, 0}, along_second{0, 1};  ///< the lattice and its dual
    std::vector<Tile> tiles;
    std::vector<std::vector<unsigned>> grid;

    explicit ReadyTiling(const WrittenTiling& from);
    /// The tile at `q`; on an edge the one that `lean`, a tiny step, leads into, or the class with the greater
    /// `favour`.
    const Tile& tile_at(const glm::dvec2& q, const glm::dvec2& cell, const glm::dvec2& lean, double favour) const
    {
        const auto column = std::min(static_cast<std::size_t>(cell.x * kGrid), std::size_t{kGrid - 1});
        const auto row = std::min(static_cast<std::size_t>(cell.y * kGrid), std::size_t{kGrid - 1});
        const std::vector<unsigned>& candidates = grid[row * kGrid + column];
        const Tile* best = &tiles[candidates.front()];
        if (candidates.size() == 1) return *best;
        double deepest = best->depth(q + lean) + favour * best->value;
        for (std::size_t i = 1; i < candidates.size(); ++i) {
            const Tile& tile = tiles[candidates[i]];
            if (const double depth = tile.depth(q + lean) + favour * tile.value; depth > deepest) {
                deepest = depth;
                best = &tile;
            }
        }
        return *best;
    }
};

Tile moved(const WrittenPolygon& polygon, double radius, const glm::dvec2& by)
{
    Tile tile{polygon.value, polygon.least, {}};
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const glm::dvec2 a = polygon.corners[i] + by, b = polygon.corners[(i + 1) % polygon.corners.size()] + by;
        const glm::dvec2 inward = glm::normalize(glm::dvec2(a.y - b.y, b.x - a.x));
        tile.edges.push_back({inward, glm::dot(inward, a), polygon.wide_edges >> i & 1u ? 1.0 / 3.0 : radius});
    }
    return tile;
}

ReadyTiling::ReadyTiling(const WrittenTiling& from) : classes(from.classes), first(from.first), second(from.second)
{
    const double area = first.x * second.y - first.y * second.x;
    along_first = glm::dvec2(second.y, -second.x) / area;
    along_second = glm::dvec2(-first.y, first.x) / area;
    grid.resize(kGrid * kGrid);
    const double reach = 0.5 * std::max(glm::length(first + second), glm::length(first - second)) / kGrid;
    for (int u = -2; u <= 2; ++u)
        for (int v = -2; v <= 2; ++v)
            for (const WrittenPolygon& polygon : from.polygons) {
                const Tile tile = moved(polygon, from.radius, double(u) * first + double(v) * second);
                bool used = false;
                for (int row = 0; row < kGrid; ++row)
                    for (int column = 0; column < kGrid; ++column) {
                        const glm::dvec2 middle = ((column + 0.5) * first + (row + 0.5) * second) / double(kGrid);
                        if (tile.depth(middle) < -reach) continue;
                        grid[static_cast<std::size_t>(row * kGrid + column)].push_back(
                            static_cast<unsigned>(tiles.size()));
                        used = true;
                    }
                if (used) tiles.push_back(tile);
            }
}

const std::vector<ReadyTiling>& ready_tilings()
{
    static const std::vector<ReadyTiling> all = [] {
        const WrittenTiling written[] = {
#include "render/texture/patterns/tilings.inc"
        };
        return std::vector<ReadyTiling>(std::begin(written), std::end(written));
    }();
    return all;
}

/// Which side an edge belongs to, in units of the tiles: far below what a picture shows, far above rounding. Measured
/// at the corners of the tiles: toward +z and +x; tiling 12 is mirrored in the middle of its period; tiling 8 prefers
/// its squares.
constexpr double kLean = 1e-10;

/// Of tiling 12 where z is a whole number of periods, to the last bit: POV-Ray finds no tile there, as in 13 and 14 at
/// z = 0. uv_mapping asks nowhere else.
constexpr double kSeam = 0.33331335;

double polygon_tiling(int kind, const glm::dvec2& p)
{
    const ReadyTiling& tiling = ready_tilings()[static_cast<std::size_t>(kind - 1)];
    glm::dvec2 cell(glm::dot(tiling.along_first, p), glm::dot(tiling.along_second, p));
    const glm::dvec2 whole = glm::floor(cell);
    cell -= whole;
    if (kind == 12 && cell.y == 0.0) return kSeam;
    if ((kind == 13 || kind == 14) && p.y == 0.0) return 0.0;
    const glm::dvec2 q = p - whole.x * tiling.first - whole.y * tiling.second;
    glm::dvec2 lean(0.25 * kLean, kLean);
    if (kind == 12) lean = {cell.x < 0.5 ? -lean.x : lean.x, cell.y < 0.5 ? -lean.y : lean.y};
    const Tile& tile = tiling.tile_at(q, cell, lean, kind == 8 ? 2.0 * kLean : 0.0);
    double shade = 0.0;
    for (const TileEdge& edge : tile.edges) shade = std::max(shade, 1.0 - edge.distance(q) / edge.radius);
    // POV-Ray takes one kind of triangle for the other where x is whole.
    const double value = kind == 3 && p.x == std::floor(p.x) ? 1.0 - tile.value : tile.value;
    return std::max(value + std::min(shade, 1.0), tile.least) / tiling.classes;
}

}  // namespace

double tiling(const Pattern& pattern, const glm::dvec3& p)
{
    if (!std::isfinite(p.x + p.z)) return 0.0;  // a warp's singular point
    const int kind = static_cast<int>(pattern.numbers[0]);
    return kind <= 24 ? polygon_tiling(kind, {p.x, p.z}) : penrose(kind, {p.x, p.z});
}

}  // namespace texture
