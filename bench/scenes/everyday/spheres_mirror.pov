#include "everyday.inc"
Camera_And_Sun(<0, 6, -12>, <0, 0, 0>)
#for (i, 0, 3000) sphere {
    <rand(R)*16-8, rand(R)*6-3, rand(R)*16-8>, 0.1+0.25*rand(R)
    pigment { rgb <rand(R), rand(R), rand(R)> }
    finish { reflection .4 phong 1 }
  } #end
plane { y, -4 pigment { checker Gray20 White } }
sky_sphere { pigment { gradient y color_map { [0 White] [1 Blue] } } }
