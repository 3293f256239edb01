#include "everyday.inc"
Camera_And_Sun(<0, 4, -9>, <0, .5, 0>)
#declare V = sor { 7, <0, -.1>, <.4, 0>, <.6, .4>, <.2, .9>, <.35, 1.3>, <.5, 1.5>, <.5, 1.6> open };
#declare L = lathe { cubic_spline 8, <0, -.2>, <.5, 0>, <.55, .4>, <.2, .7>, <.25, 1>, <.4, 1.4>, <.1, 1.6>, <0, 1.7> };
#for (i, -3, 3) #for (j, 0, 4) object {
      V
      pigment { rgbf <.7, .9, .8, .7> }
      finish { specular .6 reflection .1 }
      interior { ior 1.3 }
      translate <i*1.3, 0, j*1.5>
    } object { L pigment { rgb <.8, .5, .3> } finish { phong .5 } translate <i*1.3+.65, 0, j*1.5+.7> } #end #end
plane { y, 0 pigment { checker White Gray30 } }
