#include "everyday.inc"
Camera_And_Sun(<0, 3, -8>, <0, 0, 0>)
#for (i, -2, 2) #for (j, 0, 2) quartic {
      <1, 0, 0, 0, 2, 0, 0, 2, 0, -2*(1.2*1.2+.35*.35), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0,
        2*(1.2*1.2-.35*.35), 0, 0, 0, 0, 1, 0, -2*(1.2*1.2+.35*.35), 0, pow(1.2*1.2-.35*.35, 2)>
      scale .7
      rotate <i*40, j*30, 0>
      translate <i*2, j*1.5-1, j>
      pigment { rgb <rand(R), rand(R), rand(R)> }
      finish { specular .5 }
    }
    poly {
      4, <1, 0, 0, 0, 0, 0, 0, 0, 0, -5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, -5, 0, 0, 0, 0, 1, 0, -5, 0, 11.8>
      scale .3
      translate <i*2+1, j*1.5-1, j>
      pigment { rgb <rand(R), rand(R), rand(R)> }
    }
  #end #end
plane { y, -2 pigment { checker White Gray30 } }
