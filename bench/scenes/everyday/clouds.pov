#include "everyday.inc"
Camera_And_Sun(<0, 2, -8>, <0, 3.5, 0>)
plane {
  y, 40 hollow
  pigment {
    bozo turbulence .8 octaves 8 omega .55
    color_map { [0 rgbt <1, 1, 1, 0>] [.4 rgbt <.9, .9, .95, .3>] [.6 rgbt 1] [1 rgbt 1] }
    scale 25
  }
  finish { ambient 1 diffuse 0 }
}
plane {
  y, 0
  pigment { rgb <.1, .25, .35> }
  normal { ripples .3 frequency .5 turbulence .4 }
  finish { reflection { .1, .9 fresnel } }
  interior { ior 1.33 }
}
sky_sphere { pigment { gradient y color_map { [0 rgb <.8, .85, .9>] [1 rgb <.2, .4, .8>] } } }
box {
  <-1, 0, 2>, <1, 2, 4>
  texture { pigment { brick rgb .8, rgb <.7, .3, .2> scale .08 } normal { brick .4 scale .08 } }
}
