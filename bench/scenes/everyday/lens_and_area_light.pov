#include "everyday.inc"
camera { location <0, 3, -8> look_at <0, .5, 0> angle 35 aperture .5 focal_point <0, .5, 0> blur_samples 20 }
light_source { <20, 30, -20> rgb 1 area_light 4*x, 4*y, 4, 4 adaptive 1 jitter }
#for (i, 0, 40) sphere {
    <rand(R)*6-3, .35, rand(R)*10-4>, .35
    pigment { rgb <rand(R), rand(R), rand(R)> }
    finish { phong .8 reflection .15 }
  } #end
plane { y, 0 pigment { checker White Gray30 } }
