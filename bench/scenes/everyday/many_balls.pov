#include "everyday.inc"
Camera_And_Sun(<0, 2, -5>, <0, 0, 0>)
union {
  #for (i, 0, 6000)
    #local q = i/6000;
    #local a = i*2.39996;
    #local r = sqrt(q)*2.4;
    sphere { <r*cos(a), .5*sin(r*4), r*sin(a)>, .035 }
  #end
  pigment { gradient y color_map { [0 Red] [1 Yellow] } translate -.5*y }
  finish { phong .7 }
}
plane { y, -.8 pigment { rgb .8 } finish { reflection .2 } }
