#include "csg/freeform.h"
#include "parser/grammar/shape_makers.h"

namespace parser {

bool make_sphere_sweep(SceneBuilder&, const scene::Statement& statement, scene::Object& object)
{
    using csg::SphereSweep;
    SphereSweep::Spline spline = SphereSweep::Spline::Linear;
    std::vector<SphereSweep::Ball> balls;
    for (const scene::StatementItem& item : statement.items) {
        if (item.name == "cubic_spline") spline = SphereSweep::Spline::Cubic;
        else if (item.name == "b_spline") spline = SphereSweep::Spline::B;
        else if (item.name == "sphere") balls.push_back({std::get<glm::dvec3>(item.operands[0]), number_of(item.operands[1])});
    }
    object.shape = scene::Freeform{csg::make_freeform<SphereSweep>(spline, std::span<const SphereSweep::Ball>(balls))};
    return true;
}

}  // namespace parser
