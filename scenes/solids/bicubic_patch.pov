// Bicubic patches: coarse and fine, flat enough, mirrored, two-faced, with uv, cut and clipped (which a patch ignores).
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.2, 0.4, -9> look_at <0, 0, 0> angle 42 }
light_source { <-5, 8, -10> rgb 1 }
background { rgb <0.22, 0.24, 0.3> }

#macro Sail(Kind, Flat, U, V)
  bicubic_patch {
    type Kind flatness Flat u_steps U v_steps V
    uv_vectors <0, 0> <1, 0> <1, 1> <0, 1>
    <-1, -0.9, 0>, <-0.3, -1, 0.6>, <0.4, -0.8, -0.9>, <1, -1, 0>
    <-1.1, -0.3, 0.4>, <-0.3, -0.3, -2>, <0.3, -0.4, 0.8>, <0.9, -0.3, 0.3>
    <-0.9, 0.3, 0>, <-0.4, 0.4, 0.7>, <0.3, 0.3, -2.2>, <1.1, 0.4, 0>
    <-1, 1, 0>, <-0.3, 0.8, -0.7>, <0.4, 1, 0.5>, <1, 0.9, -0.2>
#end

object { Sail(0, 0, 1, 1) } pigment { rgb <0.9, 0.7, 0.3> } rotate 20*y translate <-2.4, 1.25, 0> }
object { Sail(1, 0, 4, 4) } pigment { rgb <0.4, 0.7, 0.9> } finish { phong 0.6 } rotate 20*y translate <0, 1.25, 0> }
object { Sail(1, 0.08, 5, 4) } pigment { rgb <0.5, 0.85, 0.4> } scale <-0.9, 1, 1> rotate -20*y translate <2.4, 1.25, 0> }
object {
  Sail(0, 0, 3, 3) }
  uv_mapping
  texture { pigment { checker rgb 0.2, rgb <0.9, 0.8, 0.6> scale 0.25 } }
  interior_texture { pigment { rgb <0.8, 0.3, 0.3> } }
  rotate 165*y translate <-2.4, -1.25, 0>
}
difference {
  object { Sail(1, 0, 3, 3) } }
  cylinder { <0.2, 0, -3>, <0.2, 0, 3>, 0.5 }
  pigment { rgb <0.7, 0.5, 0.9> }
  translate <0, -1.25, 0>
}
object { Sail(1, 0, 3, 2) } clipped_by { plane { x, 0 } } inverse pigment { rgb <0.9, 0.5, 0.5> } rotate <30, 0, 40> scale 0.8 translate <2.4, -1.25, 0> }
