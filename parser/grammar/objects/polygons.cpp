#include "csg/freeform/freeform.h"
#include "parser/grammar/core/solid_reader.h"

namespace parser {
namespace {

/// Whether the last loop of the points comes back to where it began.
bool closed_outline(const std::vector<glm::dvec3>& corners)
{
    bool closed = true;
    for (std::size_t first = 0; first < corners.size();) {
        std::size_t last = first + 1;
        while (last < corners.size() && glm::distance(corners[first], corners[last]) >= kSamePoint) ++last;
        closed = last < corners.size();
        first = last + 1;
    }
    return closed;
}

/// Loops that end exactly where they begin.
std::vector<glm::dvec3> closed_loops(const std::vector<glm::dvec3>& points)
{
    std::vector<glm::dvec3> corners;
    std::size_t first = 0;
    for (const glm::dvec3& point : points) {
        corners.push_back(point);
        const glm::dvec3 apart = glm::abs(corners.back() - corners[first]);
        if (corners.size() - 1 == first || glm::max(apart.x, glm::max(apart.y, apart.z)) >= kSamePoint) continue;
        corners.back() = corners[first];  // closed: the next corner begins another loop
        first = corners.size();
    }
    if (first < corners.size()) corners.push_back(corners[first]);
    return corners;
}

void need_three(BlockState& s, int count)
{
    if (count < 3) s.fail("a polygon needs at least three points");
}
using polygon_rule = counted<&scene::Polygon::points, need_three>;

}  // namespace

Form parameters_form(const SolidReader*, const scene::Polygon*, Kind) { return form_of<polygon_rule>(); }

bool read_parameters(SolidReader& s, scene::Polygon& polygon)
{
    read_solid<polygon_rule>(s, polygon);
    if (!closed_outline(polygon.points))
        s.in().warn_when_closed(s.source(), "this polygon is not closed: it is closed now");
    s.object().shape = scene::Freeform{csg::make_freeform<csg::Polygon>(closed_loops(polygon.points))};
    return true;
}

}  // namespace parser
