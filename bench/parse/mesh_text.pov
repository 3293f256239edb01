// A mesh as text, of triangles with and without normals: made by bench/parse_inputs.py.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "mesh_text.inc"
object { Land pigment { rgb <0.3, 0.6, 0.3> } }
#debug concat("total ", str(max_extent(Land).x, 0, 3), "\n")
camera { location <0.5, 1, -1> look_at <0.5, 0, 0.5> }
light_source { <100, 200, -200>, rgb 1 }
