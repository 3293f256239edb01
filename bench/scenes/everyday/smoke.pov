#include "everyday.inc"
camera { location <0, 1, -6> look_at <0, 1, 0> angle 45 }
light_source { <10, 20, -10> rgb 1 }
sphere {
  0, 1
  pigment { rgbt 1 } hollow
  interior {
    media {
      scattering {
        1, .8
      } absorption .3 samples 12 density { spherical turbulence .6 color_map { [0 rgb 0] [.3 rgb .3] [1 rgb 2] } }
    }
  }
  scale 1.8
  translate y
}
plane { y, -1 pigment { checker White Gray30 } }
