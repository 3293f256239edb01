#pragma once

#include "csg/base/hit.h"
#include "csg/bvh/bvh.h"
#include "csg/items/world_data.h"

#include <array>
#include <utility>
#include <vector>

namespace csg {

/// A place where a line passes through the boundary of a solid.
struct LineEnd {
    double t = 0.0;
    PartId part = kNoPart;
    std::uint32_t face = 0;
    std::uint32_t instance = Hit::kNoInstance;
    bool inverted = false;
};

/// A part of a line inside of solids.
struct Chord {
    LineEnd in, out;
    double length() const { return out.t - in.t; }
};

/// Lines that are asked together: each through a point along a unit vector, and the range of it that is asked about.
struct LineTile {
    std::array<Ray, kTileRays> lines;
    std::array<double, kTileRays> from, to;
    std::size_t count = 0;

    void add(const Ray& line, double first, double last)
    {
        lines[count] = line;
        from[count] = first;
        to[count++] = last;
    }
};
using ChordTile = std::array<std::vector<Chord>, kTileRays>;

/// Where a line is in a box that is wider by `room` on each side, from and to; nowhere if the first is above the
/// second.
std::pair<double, double> line_in_box(const Aabb& box, const Ray& line, double room = 0.0);

/// The set of points inside of a world's items, asked by lines. For any number of threads.
class InsideLines {
public:
    /// \param world outlives this
    explicit InsideLines(const WorldData& world);

    /// A box around the inside. Sides are infinite where nothing says where it ends; empty: there is no inside.
    const Aabb& bounds() const { return bounds_; }
    /// Of a sphere that holds the box, where that is finite; else 0.
    double radius() const { return radius_; }
    double slack() const { return slack_; }

    /// The parts inside of the line that meet [from, to], correct within that range only. Sorted and disjoint. Chords
    /// and gaps shorter than slack() are left out: faces in one place leave such films. Wherever the line's point is,
    /// it is followed from before the inside: the same place is told for the same line; of isosurfaces and short
    /// ranges, up to their accuracy. Where there is no end it is followed from `from`, which is finite then.
    void chords(const Ray& line, double from, double to, std::vector<Chord>& out) const;
    /// The same of many, to the bit.
    void chords(const LineTile& lines, ChordTile& out) const;

private:
    class TileLeaf;
    /// A line as it is followed: `back` before its point, from first to last.
    struct Followed {
        Ray ray;
        double back, first, last;
    };
    Followed followed(const Ray& line, double from, double to) const;
    void finish(std::vector<Chord>& chords, double back) const;

    const WorldData& world_;
    Aabb bounds_;
    std::vector<Aabb> boxes_;           ///< around the inside of each item
    std::vector<std::uint32_t> apart_;  ///< items that no hierarchy takes
    Bvh hierarchy_;                     ///< of the others
    glm::dvec3 middle_{0.0};
    double radius_ = 0.0, slack_ = 0.0;
};

}  // namespace csg
