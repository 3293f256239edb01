#include "everyday.inc"
Camera_And_Sun(<0, 3, -6>, <0, .5, 0>)
merge {
  #for (i, 0, 7)
    sphere { <cos(i*.8), .6, sin(i*.8)>, .6 }
  #end
  cylinder { 0, 1.6*y, .5 }
  torus { 1.2, .2 translate .3*y }
  pigment { rgbf <.9, .95, 1, .9> }
  finish { specular .8 reflection { .05, .8 fresnel } conserve_energy }
  interior { ior 1.4 }
}
intersection {
  sphere { <-.3, 0, 0>, .8 }
  sphere { <.3, 0, 0>, .8 }
  box { -.5, .5 }
  translate <2.2, .5, -1>
  pigment { rgbf .9 }
  interior { ior 1.6 }
  finish { reflection .1 }
}
plane { y, -.01 pigment { checker White Gray30 scale .5 } }
