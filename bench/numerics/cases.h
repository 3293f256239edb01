#pragma once

#include "bench/numerics/forms.h"
#include "csg/solids/solid.h"
#include "tests/csg/support.h"

#include <functional>
#include <string>
#include <vector>

namespace numerics {

/// A solid of a sweep at one value of its parameter, and where rays at it start.
struct Case {
    csg::Solid solid;
    glm::dvec3 target{0.0};      ///< rays pass near it
    double spread = 1.0;         ///< within this distance
    double distance = 6.0;       ///< from there
    double size = 1.0;           ///< the object's scale
    std::string sdl;             ///< the same in the scene language, for trace(); empty: not compared
    const Form* form = nullptr;  ///< what judges it; none: its polynomials do
};

struct Sweep {
    std::string name;
    std::string parameter;  ///< what is swept, for people
    std::vector<double> values;
    std::function<Case(const std::string& solid, double value)> make;
    std::vector<std::string> solids;
};

std::vector<Sweep> sweeps();

/// The worst error, relative to the larger of distance and size, that a kind may show outside the tangency band.
double bar_of(const std::string& solid);
/// Chords shorter than this part of the object's size lie in the tangency band: there a hit may come or go.
double band_of(const std::string& solid);

}  // namespace numerics
