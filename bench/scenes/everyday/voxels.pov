#include "everyday.inc"
Camera_And_Sun(<-9, 9, -12>, <0, 0, 0>)
#for (i, -30, 29) #for (j, -30, 29) #local h = int(4*(1+sin(i*.3)*cos(j*.25))); box {
      <i*.2, -1, j*.2>, <i*.2+.2, h*.2, j*.2+.2>
      pigment { rgb <.3+.08*h, .6-.05*h, .2> }
    } #if (mod(i*7+j*13, 17) = 0) box {
        <i*.2, h*.2, j*.2>, <i*.2+.2, h*.2+.6, j*.2+.2>
        pigment { Brown }
      } sphere { <i*.2+.1, h*.2+.8, j*.2+.1>, .3 pigment { Green } } #end #end #end
sky_sphere { pigment { rgb <.6, .8, 1> } }
