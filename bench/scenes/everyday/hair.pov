#include "everyday.inc"
Camera_And_Sun(<0, 1, -5>, <0, .8, 0>)
#for (i, 0, 500) #local a = rand(R)*2*pi; #local d = <cos(a), 1.2, sin(a)>*.6; sphere_sweep {
    b_spline 5, d*.3, .02, d*.8, .02, d*1.2+.1*<rand(R)-.5, 0, rand(R)-.5>, .018,
    d*1.6-.15*y+.2*<rand(R)-.5, 0, rand(R)-.5>, .012, d*1.9-.6*y, .008
    pigment { rgb <.6, .4, .15> }
    finish { specular .4 }
  } #end
sphere { .3*y, .5 pigment { rgb <.9, .7, .6> } }
plane { y, -.3 pigment { checker White Gray40 } }
