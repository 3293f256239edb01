#include "everyday.inc"
Camera_And_Sun(<0, 5, -9>, <0, 0, 0>)
#for (i, -4, 4) #for (k, -3, 4) superellipsoid {
      <.1+.2*abs(i), .1+.3*abs(k)>
      scale .45
      rotate <10*i, 20*k, 0>
      translate <i*1.1, 0, k*1.1>
      pigment { rgb <rand(R), rand(R), rand(R)> }
      finish { phong .6 reflection .15 }
    } #end #end
plane { y, -.8 pigment { checker White Gray30 } finish { reflection .2 } }
