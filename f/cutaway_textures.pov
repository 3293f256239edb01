// cutaway_textures: cut faces take the texture of the operand that was cut.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <1.8, 2.4, -4> look_at 0 angle 40 }
light_source { <3, 6, -6> rgb 1 }
background { rgb 0.2 }

difference {
  union {
    sphere { <-0.5, 0, 0>, 0.9 pigment { rgb <0.8, 0.3, 0.2> } }
    sphere { <0.7, 0, 0>, 0.8 pigment { rgb <0.2, 0.5, 0.8> } }
  }
  box { <-2, 0.2, -2>, <2, 2, 2> }
  plane { z, -0.4 }
  cutaway_textures
}
