// Land of a ridged fractal of x and z: of eight octaves of noise at y = 0 all eight corners of a cell were asked for, half of which have no share.
#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1 }
camera { location <0, 4, -12> look_at <0, 1, 0> angle 55 }
light_source { <-50, 40, -20>, rgb <1.2, 1.1, .9> }
sky_sphere { pigment { gradient y color_map { [0 rgb <.9, .8, .7>] [.5 rgb <.2, .4, .8>] } } }
isosurface {
  function { y - 1.3*f_ridged_mf(.25*x, 0, .25*z, .9, 2.2, 8, .8, 2, 2) }
  contained_by { box { <-14, -2, -9>, <14, 4, 18> } }
  max_gradient 4 accuracy .005
  texture {
    slope { y }
    texture_map {
      [.45 pigment { granite color_map { [0 rgb .25] [1 rgb .6] } } normal { granite .5 scale .2 }]
      [.8 pigment { bozo color_map { [0 rgb <.3, .4, .15>] [1 rgb <.15, .25, .08>] } scale .2 }]
      [.95 pigment { rgb <.95, .95, 1> } finish { specular .2 }]
    }
  }
}
plane { y, .35 pigment { rgb <.1, .2, .25> } finish { reflection { .05, .9 fresnel } conserve_energy } interior { ior 1.33 } }
