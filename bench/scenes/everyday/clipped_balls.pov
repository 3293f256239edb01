#include "everyday.inc"
Camera_And_Sun(<0, 3, -7>, <0, 0, 0>)
#for (i, 0, 30) sphere {
    0, 1
    clipped_by { plane { y, .3 } plane { x, .5 rotate 40*i*y } }
    bounded_by { sphere { 0, 1.01 } }
    scale .7
    rotate <rand(R)*360, rand(R)*360, 0>
    translate <rand(R)*6-3, rand(R)*3-1, rand(R)*6-3>
    pigment { rgb <rand(R), rand(R), rand(R)> }
    finish { phong .5 }
  } #end
plane { y, -1.8 pigment { checker White Gray30 } }
