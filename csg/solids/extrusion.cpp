#include "csg/solids/extrusion.h"

#include "csg/solids/shared/outline_crossings.h"

namespace csg {

void Extrusion::meet_walls(const glm::dvec2& from, const glm::dvec2& along, double nearest, double farthest,
                           bool first_only, Walls& out) const
{
    OutlineLine line;
    line.side = {-along.y, along.x};
    line.level = glm::dot(line.side, from);
    line.along = along;
    const double square = glm::dot(along, along), over = 1.0 / square, start = glm::dot(from, along);
    // A part of what goes into it: more than the roundings of a wall's place.
    const double coarse = 1e-14 * (std::abs(from.x * along.x) + std::abs(from.y * along.y));
    const auto room = [&](double t) { return coarse + 1e-14 * std::abs(t) * square; };
    line.lo = start + nearest * square - room(nearest);
    line.hi = start + farthest * square + room(farthest);
    std::size_t count = 0;
    out.odd_before = outline_crossings(*shape, line, [&](double w, std::uint32_t piece) {
        const Wall wall{glm::dot(shape->pieces()[piece].at(w) - from, along) * over, kFirstWall + piece};
        if (first_only && wall.t >= nearest) line.hi = std::min(line.hi, start + wall.t * square + room(wall.t));
        if (count == kMostWalls) {
            if (wall.t >= out.walls[count - 1].t) return;
            --count;
        }
        std::size_t at = count++;
        for (; at > 0 && out.walls[at - 1].t > wall.t; --at) out.walls[at] = out.walls[at - 1];
        out.walls[at] = wall;
    });
    out.count = count;
}

}  // namespace csg
