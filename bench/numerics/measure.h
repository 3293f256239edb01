#pragma once

#include "bench/numerics/cases.h"

#include <string>
#include <vector>

namespace numerics {

/// Errors count against the bar where the cosine of incidence is at least this; below it they are told apart.
inline constexpr double kClear = 0.01;

/// A test of the judge itself: of each seven rays one loses one of the ends told, another gains one. Set once, before
/// measuring.
inline bool spoiled = false;

struct Row {
    std::string sweep, solid;
    double value = 0;
    long rays = 0, hits = 0, missed = 0, wrong = 0;
    double worst = 0, median = 0;  ///< error over the larger of distance and size, at clear incidence
    double grazing = 0;            ///< the worst of the others
    double ns = 0;                 ///< for one ray
    double spawn = 0;  ///< farthest that a spawned ray meets its own start again, over the larger of size and |p|
    double acne = 0,
           lost = 0;  ///< per million spawned rays: own start met beyond the renderer's tolerance; a far side within it
    long disagree = 0;  ///< points that contains() and the oracle sort differently
    bool passes() const;
};

/// A ray and what the oracle says is met first beyond the renderer's tolerance; for comparisons with other programs.
struct Asked {
    csg::Ray ray;
    bool hit = false, clear = true;
    double t = 0;
};

/// `timed`: also how long a ray takes.
Row measure(const Sweep& sweep, const std::string& solid, double value, long rays, bool timed,
            std::vector<Asked>* asked);

}  // namespace numerics
