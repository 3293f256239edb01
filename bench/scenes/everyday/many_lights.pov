#include "everyday.inc"
Camera_And_Sun(<0, 4, -8>, <0, 0, 0>)
#for (i, 0, 24) light_source {
    <cos(i)*6, 4+mod(i, 3), sin(i)*6> rgb <rand(R), rand(R), rand(R)>*.15 spotlight point_at <0, 0,
      0> radius 10 falloff 40
  } #end
#for (i, 0, 60) torus {
    .5, .12
    rotate <rand(R)*360, rand(R)*360, 0>
    translate <rand(R)*8-4, .5+rand(R), rand(R)*8-4>
    pigment { rgb .8 }
    finish { specular .5 }
  } #end
plane { y, 0 pigment { rgb .8 } }
