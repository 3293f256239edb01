#include "everyday.inc"
Camera_And_Sun(<0, 3, -5>, <0, 0, 0>)
#macro Flake(C, Rad, D, Dep) sphere {
    C, Rad
  } #if (Dep > 0) #for (k, 0, 5) #local a = k*60; #local d = vrotate(x, <0, a, 25+Dep*5>); Flake(C+d*Rad*1.4, Rad*.4, d,
        Dep-1) #end #local d = y; Flake(C+d*Rad*1.4, Rad*.4, d, Dep-1) #end #end
union { Flake(<0, 0, 0>, 1, y, 4) pigment { rgb <.8, .7, .3> } finish { reflection .3 specular .7 } }
plane { y, -1.3 pigment { marble scale .5 } finish { reflection .1 } }
