// What has textures of its parts under `uv_mapping`: those of a blob's components move with it; those of a mesh's faces
// stay where the mesh itself is mapped, and move where the mapping is that of a group around it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -12> look_at 0 angle 36 }
light_source { <-20, 30, -40> rgb 1 }
background { rgb <0.2, 0.25, 0.3> }
#declare Stripes = texture { pigment { gradient x color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.7 } finish { ambient 0.6 diffuse 0.4 } }
#declare Squares = texture { pigment { checker rgb 1 rgb <0.2, 0.4, 0.8> scale 0.3 } normal { gradient x 0.5 scale 0.3 } }

#macro Ball(Mapped, Turn)
  blob { threshold 0.5 sphere { 0, 1.3, 1 texture { Stripes } } sphere { 0.7*x, 1.2, 1 } #if (Mapped) uv_mapping #end texture { Squares } rotate Turn*z }
#end
object { Ball(true, 40) translate <-2.8, 1.5, 0> }
object { Ball(false, 40) translate <-0.4, 1.5, 0> }
merge { object { Ball(true, 0) scale 0.7 } rotate 70*z translate <1.9, 1.5, 0> }

#declare Kite = mesh2 {
  vertex_vectors { 4, <-1, 0, 0>, <0, -1, 0>, <1, 0, 0>, <0, 1, 0.3> }
  uv_vectors { 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }
  texture_list { 2, texture { Stripes }, texture { Squares } }
  face_indices { 2, <0, 1, 2>, 0, 1, 0, <0, 2, 3>, 0 }
}
object { Kite uv_mapping texture { Squares } rotate <20, 0, 30> translate <-3, -1.3, 0> }
union { object { Kite rotate 30*z } uv_mapping texture { Squares } rotate 20*x translate <-0.9, -1.3, 0> }
difference { object { Kite rotate 30*z } sphere { <0, 0.4, 0>, 0.3 } uv_mapping texture { Squares } scale 0.8 rotate 60*z translate <1.2, -1.3, 0> }
object { Kite rotate <20, 0, 30> translate <3.1, -1.3, 0> }
