#pragma once

#include "parser/grammar/statement.h"

/// Shapes made of the statements that are kept as written.
namespace parser {

/// False: this statement cannot be drawn yet.
using ShapeMaker = bool (*)(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);

/// Asks the maker of the statement's keyword, if it has one.
bool make_shape(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);

bool make_bicubic_patch(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_blob(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_height_field(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_isosurface(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_julia(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_lathe(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_ovus(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_parametric(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_polygon(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_polynomial(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_prism(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_sor(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_sphere_sweep(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_superellipsoid(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);
bool make_text(SceneBuilder& build, const scene::Statement& statement, scene::Object& object);

}  // namespace parser
