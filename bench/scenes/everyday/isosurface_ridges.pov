#include "everyday.inc"
Camera_And_Sun(<0, 3, -8>, <0, 0, 0>)
isosurface {
  function {
    y - f_ridged_mf(x*.5, 0, z*.5, .6, 2.2, 6, .8, 1.3, 2)*1.0
  } contained_by { box { <-6, -2, -4>, <6, 3, 12> } } max_gradient 4 accuracy .005
  pigment { slope y color_map { [.5 rgb .3] [.9 rgb <.3, .6, .2>] } }
}
plane { y, -.5 pigment { rgb <.1, .3, .5> } finish { reflection .4 } }
sky_sphere { pigment { gradient y color_map { [0 White] [1 rgb <.2, .4, .9>] } } }
