#include "parser/grammar/shape_makers.h"

namespace parser {

bool make_shape(SceneBuilder& build, const scene::Statement& statement, scene::Object& object)
{
    static constexpr struct {
        std::string_view keyword;
        ShapeMaker make;
    } kMakers[] = {
        {"bicubic_patch", make_bicubic_patch},
        {"blob", make_blob},
        {"cubic", make_polynomial},
        {"height_field", make_height_field},
        {"isosurface", make_isosurface},
        {"julia_fractal", make_julia},
        {"lathe", make_lathe},
        {"ovus", make_ovus},
        {"parametric", make_parametric},
        {"poly", make_polynomial},
        {"polygon", make_polygon},
        {"polynomial", make_polynomial},
        {"prism", make_prism},
        {"quartic", make_polynomial},
        {"sor", make_sor},
        {"sphere_sweep", make_sphere_sweep},
        {"superellipsoid", make_superellipsoid},
        {"text", make_text},
    };
    for (const auto& maker : kMakers)
        if (maker.keyword == statement.keyword) return maker.make(build, statement, object);
    return false;
}

}  // namespace parser
