#include "everyday.inc"
Camera_And_Sun(<0, 2, -7>, <0, 0, 0>)
blob {
  threshold .5
  #for (i, 0, 150)
    sphere { <rand(R)*5-2.5, rand(R)*3-1.5, rand(R)*3-1.5>, .6, 1 }
  #end
  #for (i, 0, 20)
    cylinder { <rand(R)*5-2.5, rand(R)*3-1.5, 0>, <rand(R)*5-2.5, rand(R)*3-1.5, 1>, .3, .8 }
  #end
  pigment { agate }
  finish { specular .5 reflection .2 }
}
plane { y, -2.3 pigment { checker White Gray30 } }
