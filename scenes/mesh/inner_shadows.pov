// Shadows of meshes with an inner texture: where a mesh and all of its faces are opaque, the inner texture lets no light through, in CSG too;
// where one of them is clear, and in every other solid, it does.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -0.01> look_at 0 angle 62 }
light_source { <-6, 7.4, -3.6> rgb 1 }
plane { y, -1 pigment { rgb 1 } }
#declare Clear = texture { pigment { rgbt <1, 1, 1, 0.4> } }
#declare Red = texture { pigment { rgb x } }
#declare Blue = texture { pigment { rgb z } }
#declare A = <-1, 0, -1>; #declare B = <1, 0, -1>; #declare C = <0, 0, 0.7>;

#declare Plain = mesh { triangle { A, B, C } texture { Red } interior_texture { Clear } }
#declare Painted = mesh { triangle { A, B, C texture { Blue } } texture { Red } interior_texture { Clear } }
object { Plain translate <-2.2, 0, 2.2> }
object { Painted translate <0, 0, 2.2> }
mesh { triangle { A, B, C texture { Blue } } texture { Clear } interior_texture { Clear } translate <2.2, 0, 2.2> }
mesh2 { vertex_vectors { 4, A, B, C, <0, 0.4, -1.4> } texture_list { 2 texture { Red } texture { Clear } } face_indices { 2, <0, 1, 2>, 0, <0, 1, 3>, 1 }
  texture { Red } interior_texture { Clear } translate <-2.2, 0, 0> }
mesh2 { vertex_vectors { 3, A, B, C } texture_list { 2 texture { Red } texture { Blue } } face_indices { 1, <0, 1, 2>, 0, 1, 0 } texture { Red } interior_texture { Clear } }
merge { object { Painted } sphere { 0.6*y, 0.2 texture { Clear } } translate <2.2, 0, 0> }
intersection { object { Plain } sphere { 0, 1 texture { Red } } translate <-2.2, 0, -2.2> }
triangle { A, B, C texture { Red } interior_texture { Clear } translate -2.2*z }
mesh { triangle { A, B, C } texture { checker texture { Red } texture { Blue } scale 0.3 } interior_texture { Clear } translate <2.2, 0, -2.2> }
