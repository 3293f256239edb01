#pragma once

#include "csg/solids/solid.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Solids without polynomials of their own: judged by their definition, in 64-bit mantissas and by looking everywhere.
namespace numerics {

using Wide = long double;

struct WidePoint {
    Wide x = 0, y = 0, z = 0;
};

/// A form about the origin of its own space, and its definition there.
struct Form {
    std::string name;
    /// In a frame that takes lengths `scale` times as large.
    std::function<csg::Solid(const csg::Transform& frame, double scale)> make;
    /// Of a solid: whether it holds a point.
    std::function<bool(const WidePoint&)> holds = {};
    /// Of a surface: all s where from + s way meets it, in any order. Neither: a triangle.
    std::function<std::vector<Wide>(const WidePoint& from, const WidePoint& way)> meets = {};
    /// The same verdict sooner: bounds and doubles decide what they surely can, the definition the rest. None: `holds`
    /// itself.
    std::function<bool(const WidePoint&)> quick = {};
    /// Where the normal that it is lit by is not its surface's: where that points.
    std::function<WidePoint(const WidePoint&)> slope = {};
    /// Of one that is told where a ray enters a small box about a point of the surface: how much of the ray's way, the
    /// parameter, that may be off for a unit of the box.
    std::function<double(const glm::dvec3& way, const glm::dvec3& normal)> spread = {};
    double reach = 2.0;  ///< it lies within this distance of the origin
    double bar = 1e-11;  ///< the worst error that a hit may show, of the larger of distance and size
    double band = 1e-6;  ///< shorter chords, of the size, may come or go
    int looks = 400;     ///< places on a ray that the definition is asked at, before crossings are closed in on
    double blur =
        0.0;  ///< points nearer to the surface, in the form's own lengths, may be sorted either way by POV-Ray's rules
    bool first_only = false;  ///< no more is told than the nearest
};

const std::vector<Form>& forms();
const Form* form_of(const std::string& name);

/// Parameters in [low, high] where a ray crosses the form in the frame of the solid made, ascending. `told`: what is
/// judged; the definition is asked between these places too, so that a narrow piece that was found is not called false.
std::vector<__float128> crossings(const Form& form, const csg::Transform& frame, const csg::Ray& ray, double low,
                                  double high, const std::vector<double>& told);
bool holds(const Form& form, const csg::Transform& frame, const glm::dvec3& p);
/// Whether a point lies within the form's blur of where that changes.
bool blurred(const Form& form, const csg::Transform& frame, const glm::dvec3& p);

/// The direction of the surface's own normal at p; the form has a `slope`.
glm::dvec3 slope(const Form& form, const csg::Transform& frame, const glm::dvec3& p);

/// The verdict of `quick` where there is one and it is wanted.
bool held(const Form& form, const WidePoint& p);

std::vector<Form> surface_forms();
std::vector<Form> outline_forms();
std::vector<Form> field_forms();
std::vector<Form> sweep_forms();

}  // namespace numerics
