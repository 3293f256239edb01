#include "everyday.inc"
Camera_And_Sun(<0, 0, -5>, <0, 0, 0>)
union {
  #for (i, 0, 35)
    torus { 1.5, .02 rotate 90*x rotate i*10*y }
  #end
  #for (i, -8, 8)
    torus { 1.5*cos(i*pi/18), .02 translate 1.5*sin(i*pi/18)*y }
  #end
  pigment { rgb <.8, .6, .2> }
  finish { metallic specular .7 reflection .2 }
}
sphere { 0, 1.2 pigment { rgb <.2, .3, .6> } finish { reflection .3 } }
plane { y, -1.8 pigment { checker White Gray40 } }
