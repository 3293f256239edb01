#pragma once

#include "bench/numerics/cases.h"

#include <string>
#include <vector>

namespace numerics {

/// Errors count against the bar where the cosine of the angle of incidence is at least this; grazing hits below it are
/// reported separately (Row::grazing).
inline constexpr double kClear = 0.01;

/// A test of the judge itself: of every seven rays, one loses a crossing and another gains one, which has to be
/// noticed. Set once, before measuring.
inline bool spoiled = false;

struct Row {
    std::string sweep, solid;
    double value = 0;
    long rays = 0, hits = 0, missed = 0, wrong = 0;
    double worst = 0, median = 0;  ///< error over the larger of distance and size, at clear incidence
    double grazing = 0;            ///< the worst of the others
    double ns = 0;                 ///< for one ray
    double spawn = 0;   ///< farthest that a spawned ray meets its own start again, over the larger of size and |p|
    double acne = 0;    ///< per million spawned rays: those that meet their own start beyond the renderer's tolerance
    double lost = 0;    ///< per million spawned rays: those whose far side lies within that tolerance
    long disagree = 0;  ///< points that contains() puts on another side than the oracle
    bool passes() const;
};

/// A ray, and the first crossing beyond the renderer's tolerance by the oracle; for comparisons with other programs.
struct Asked {
    csg::Ray ray;
    bool hit = false, clear = true;
    double t = 0;
};

/// Measures one solid of a sweep at one value of what the sweep varies. `timed`: measures the time of a ray too.
/// `asked`, if given, receives the rays and their true hits.
Row measure(const Sweep& sweep, const std::string& solid, double value, long rays, bool timed,
            std::vector<Asked>* asked);

}  // namespace numerics
