#include "everyday.inc"
Camera_And_Sun(<0, 4, -7>, <0, 0, 0>)
#for (i, -3, 3) #for (k, -2, 3) bicubic_patch {
      type 1 flatness .01 u_steps 4 v_steps 4
      #for (a, 0, 3)
        #for (b, 0, 3) <a*.4-.6, sin(a*1.3+i)*.4+cos(b+k)*.4, b*.4-.6>
        #end
      #end
      translate <i*1.3, 0, k*1.3>
      pigment { rgb <rand(R), rand(R), rand(R)> }
      finish { phong .6 reflection .15 }
    } #end #end
plane { y, -1.3 pigment { checker White Gray30 } }
