#include "csg/solids/extrusion.h"

#include "csg/solids/shared/outline_crossings.h"

namespace csg {

void Extrusion::meet_walls(const glm::dvec2& from, const glm::dvec2& along, double nearest, double farthest,
                           bool first_only, Walls& out) const
{
    const OutlineRay<OutlineLine, glm::dvec2, double> ray(from, along);
    OutlineLine line = ray.line(nearest, farthest);
    std::size_t count = 0;
    out.odd_before = outline_crossings(*shape, line, [&](double w, std::uint32_t piece) {
        const Wall wall{ray.at(shape->pieces()[piece].at(w)), kFirstWall + piece};
        if (first_only && wall.t >= nearest) line.hi = std::min(line.hi, ray.latest(wall.t));
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
