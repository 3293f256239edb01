#include "everyday.inc"
Camera_And_Sun(<2.2, 1.7, -2.6>, <0, 0, 0>)
#macro H(L) #local n = pow(3, L); #local s = 1/n; #for (i, 0, n-1) #for (j, 0,
        n-1) #if (mod(i, 3) = 1 & mod(j, 3) = 1) box {
          <-.5+i*s, -.5+j*s, -1>, <-.5+(i+1)*s, -.5+(j+1)*s, 1>
        } #end #end #end #end
difference {
  box { -.5, .5 }
  union { H(1) H(2) H(3) }
  union { H(1) H(2) H(3) rotate 90*x }
  union { H(1) H(2) H(3) rotate 90*y }
  pigment { rgb <.8, .7, .5> }
  finish { specular .3 }
}
plane { y, -.6 pigment { checker White Gray30 scale .3 } finish { reflection .2 } }
