#include "everyday.inc"
Camera_And_Sun(<0, 2, -6>, <0, 0, 0>)
#declare S = superellipsoid { <.2, .2> scale <.24, .08, .24> };
#for (i, -14, 14) #for (k, -8, 30) object {
      S
      rotate <rand(R)*4, rand(R)*6, rand(R)*4>
      translate <i*.5+.25*mod(k, 2), 0, k*.5-2>
      pigment { granite color_map { [0 rgb .3+.2*rand(R)] [1 rgb .7] } scale .3 translate i*3+k*5 }
      normal { bumps .3 scale .04 }
    } #end #end
plane { y, -.03 pigment { rgb .25 } }
fog { distance 30 rgb <.7, .75, .8> }
