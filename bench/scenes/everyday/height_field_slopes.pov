#include "everyday.inc"
Camera_And_Sun(<0, 2.2, -4>, <0, .2, 0>)
height_field {
  function 512, 512 { pattern { granite turbulence .3 scale .6 } } smooth water_level .1
  translate <-.5, 0, -.5>
  scale <6, 1.2, 6>
  texture { slope y texture_map { [.4 pigment { rgb .4 }] [.7 pigment { rgb <.3, .5, .2> }] [1 pigment { White }] } }
}
plane { y, .15 pigment { rgbf <.2, .4, .5, .6> } finish { reflection .3 specular .5 } normal { bumps .1 scale .1 } }
sky_sphere { pigment { gradient y color_map { [0 White] [1 rgb <.3, .5, .9>] } } }
