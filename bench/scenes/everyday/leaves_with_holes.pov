#include "everyday.inc"
Camera_And_Sun(<0, 1.5, -5>, <0, 1.2, 0>)
#for (i, 0, 700) #local a = rand(R)*360; disc {
    0, z, .25
    pigment { leopard color_map { [0 rgbt 1] [.45 rgbt 1] [.46 rgb <.2, .6, .1>] [1 rgb <.3, .7, .2>] } scale .05 }
    rotate <rand(R)*360, rand(R)*360, 0>
    translate <rand(R)*3-1.5, rand(R)*2+.4, rand(R)*2-1>
  } #end
cylinder { 0, 1.5*y, .15 pigment { wood scale .05 } }
plane { y, 0 pigment { rgb <.3, .5, .2> } }
sky_sphere { pigment { rgb <.6, .8, 1> } }
