#include "everyday.inc"
Camera_And_Sun(<3, 4, -6>, <0, .5, 0>)
difference {
  box { <-2, 0, -2>, <2, 1, 2> }
  #for (i, 0, 60)
    sphere { <rand(R)*4-2, 1, rand(R)*4-2>, .1+.2*rand(R) }
  #end
  #for (i, 0, 20)
    cylinder { <rand(R)*4-2, -1, rand(R)*4-2>, <rand(R)*4-2, 2, rand(R)*4-2>, .1 }
  #end
  texture { pigment { marble turbulence .6 scale .5 } finish { specular .4 } }
}
plane { y, 0 pigment { rgb .6 } finish { reflection .1 } }
light_source { <-10, 10, -10> rgb .6 area_light 2*x, 2*y, 5, 5 adaptive 1 jitter }
