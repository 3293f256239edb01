#include "everyday.inc"
Camera_And_Sun(<0, 1.5, -6>, <0, .3, 0>)
#declare Blade = mesh {
  triangle { <-.02, 0, 0>, <.02, 0, 0>, <0, .3, .05> } triangle { <-.02, 0, 0>, <0, .3, .05>, <-.01, .5, .15> }
  pigment { rgb <.2, .6, .1> }
};
#for (i, 0, 12000) object { Blade scale .5+rand(R) rotate rand(R)*360*y translate <rand(R)*10-5, 0, rand(R)*10-4> } #end
#for (i, 0, 200) cone {
    <rand(R)*10-5, 0, rand(R)*10-4>, .05, <rand(R)*10-5, .8, rand(R)*10-4>, 0
    pigment { rgb <.5, .4, .1> }
  } #end
plane { y, 0 pigment { bozo color_map { [0 rgb <.3, .2, .1>] [1 rgb <.2, .3, .1>] } scale .2 } }
sky_sphere { pigment { gradient y color_map { [0 White] [1 rgb <.2, .4, .9>] } } }
