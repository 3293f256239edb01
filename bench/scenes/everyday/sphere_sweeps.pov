#include "everyday.inc"
Camera_And_Sun(<0, 3, -7>, <0, 0, 0>)
#for (k, 0, 11) sphere_sweep {
    cubic_spline 14, #for (i, 0, 13) <cos(i*.9+k)*(1+.2*k), i*.3-2, sin(i*.9+k)*(1+.1*k)>, .06+.01*mod(i, 3)
    #end
    pigment { rgb <rand(R), rand(R), rand(R)> }
    finish { phong .6 reflection .1 }
  } #end
#for (k, 0, 11) sphere_sweep {
    linear_spline 8, #for (i, 0, 7) <cos(i*.9+k)*3, i*.5-2, sin(i*.9+k)*3>, .08
    #end
    pigment { rgb <rand(R), rand(R), rand(R)> }
  } #end
plane { y, -2.3 pigment { checker White Gray30 } }
