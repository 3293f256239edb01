#include "everyday.inc"
Camera_And_Sun(<0, 2, -6>, <0, .5, 0>)
blob {
  threshold .6
  #for (i, 0, 9)
    sphere { <cos(i)*1.2, .5+.4*sin(i*2), sin(i*1.3)>, .9, 1 }
  #end
  pigment { rgbf <.9, .95, 1, .9> }
  finish { specular .9 reflection { .05, 1 fresnel } }
  interior { ior 1.33 }
}
blob {
  threshold .5
  #for (i, 0, 29)
    sphere { <cos(i*.7)*2.2, .3+.01*i, sin(i*.7)*2.2>, .45, 1 }
  #end
  pigment { Red }
  finish { phong .8 }
}
plane { y, -.3 pigment { checker White Gray40 scale .5 } }
