#include "everyday.inc"
Camera_And_Sun(<0, 0, -14>, <0, 0, 0>)
#for (i, 0, 2500) #local p = <rand(R)*10-5, rand(R)*8-4, rand(R)*8-4>; sphere {
    p, .18
    pigment { rgb <rand(R), .3, .3> }
    finish { phong .9 phong_size 60 }
  } cylinder { p, p+.5*<rand(R)-.5, rand(R)-.5, rand(R)-.5>*2, .06 pigment { rgb .7 } finish { phong .5 } } #end
background { White }
light_source { <-20, 10, -30> rgb .4 }
