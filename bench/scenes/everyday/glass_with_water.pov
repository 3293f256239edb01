#include "everyday.inc"
Camera_And_Sun(<0, 2, -6>, <0, .8, 0>)
#for (i, -1, 1) #for (k, 0, 1) difference {
      sphere { 0, .7 }
      sphere { 0, .62 }
      pigment { rgbf <1, 1, 1, .95> }
      finish { specular .8 reflection { .03, .9 fresnel } }
      interior { ior 1.5 }
      translate <i*1.5, .72, k*1.6>
    } sphere { <i*1.5, .55, k*1.6>, .35 pigment { rgb <.8, .2, .1> } finish { phong .6 } } #end #end
difference {
  cylinder { <0, 0, 0>, <0, 1.4, 0>, .5 }
  cylinder { <0, .1, 0>, <0, 1.5, 0>, .45 }
  pigment { rgbf <.95, 1, 1, .95> }
  interior { ior 1.5 }
  finish { reflection .08 specular .9 }
  translate <0, .01, -1.6>
}
cylinder { <0, .11, -1.6>, <0, .9, -1.6>, .449 pigment { rgbf <.9, .3, .2, .9> } interior { ior 1.33 } }
plane { y, -.01 pigment { checker rgb .9 rgb .4 scale .5 } }
