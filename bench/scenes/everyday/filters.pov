#include "everyday.inc"
Camera_And_Sun(<0, 3, -8>, <0, .5, 0>)
#for (i, 0, 14) box {
    <-1.5, 0, 0>, <1.5, 2.2, .03>
    rotate 8*i*y
    translate <rand(R)*3-1.5, 0, i*.5-2>
    pigment { rgbf <rand(R)*.5+.5, rand(R)*.5+.5, rand(R)*.5+.5, .8> }
    finish { specular .4 }
  } #end
#for (i, 0, 14) sphere { <rand(R)*6-3, rand(R)*2, rand(R)*5-2>, .3 pigment { rgbt <.6, .8, .9, .6> } } #end
plane { y, 0 pigment { checker White Gray60 } }
