// A stone: a ball made rough by noise, an isosurface.
// bench: +W320 +H240 -A
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"
camera { location <0, 1.6, -4.5> look_at 0 angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.4, 0.5, 0.6> }
plane { y, -1.3 pigment { rgb 0.7 } }
isosurface {
  function { x*x + y*y + z*z - 1 + 0.35*f_noise3d(3*x, 3*y, 3*z) + 0.08*f_noise3d(14*x, 14*y, 14*z) }
  contained_by { sphere { 0, 1.15 } }
  max_gradient 5.5
  accuracy 0.001
  pigment { rgb <0.62, 0.56, 0.50> }
  finish { diffuse 0.8 specular 0.15 }
}
