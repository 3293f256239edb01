#include "everyday.inc"
camera { location <0, 1.5, -6> look_at 0 angle 40 } light_source { <-50, 20, -40> rgb 1.2 }
sphere {
  0, 1.3
  pigment {
    bozo turbulence .8 octaves 8 lambda 2.3
    color_map { [0 rgb <0, .1, .4>] [.5 rgb <.1, .2, .6>] [.55 rgb <.2, .5, .1>] [.8 rgb <.5, .4, .2>] [1 White] }
    scale .8
  }
  normal { granite .3 scale .4 }
  finish { specular .2 }
}
sphere {
  0, 1.33
  pigment { wrinkles turbulence .9 color_map { [0 rgbt 1] [.5 rgbt 1] [1 rgbt <1, 1, 1, .1>] } scale .5 }
  finish { diffuse .9 } hollow
}
disc {
  0, <.2, 1, .1>, 2.8, 1.7
  pigment {
    cylindrical
    color_map { [0 rgbt 1] [.1 rgbt <.8, .7, .5, .3>] [.15 rgbt .9] [.3 rgbt <.7, .6, .5, .2>] [1 rgbt .8] }
    scale 3
  }
}
sky_sphere { pigment { crackle form <1, 0, 0> color_map { [0 White] [.03 Black] } scale .02 } }
