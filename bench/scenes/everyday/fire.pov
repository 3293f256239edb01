#include "everyday.inc"
camera { location <0, 1.2, -4> look_at <0, 1, 0> angle 45 } light_source { <5, 10, -5> rgb .5 }
cylinder {
  0, 2.4*y, .9 hollow
  pigment { rgbt 1 }
  interior {
    media {
      emission 1.6 intervals 1 samples 20 method 3 density {
        cylindrical turbulence .5 octaves 5
        color_map { [0 rgb 0] [.4 rgb <.5, .1, 0>] [.8 rgb <1, .6, .1>] [1 rgb <1, 1, .6>] }
        scale <.8, 1, .8>
      } density { gradient y color_map { [0 rgb 1] [1 rgb 0] } scale 2.4 }
    }
  }
}
#for (i, 0, 6) cylinder { <-.7, 0, 0>, <.7, .25, .1>, .12 rotate i*51*y pigment { wood scale .1 } } #end
plane { y, -.01 pigment { rgb .4 } normal { bumps .4 scale .1 } }
