#include "everyday.inc"
Camera_And_Sun(<0, 2, -6>, <0, .5, 0>)
prism {
  linear_sweep linear_spline -1, 1, 4, <-1, 0>, <1, 0>, <0, 1.7>, <-1, 0>
  rotate -90*x
  pigment { rgbf 1 }
  finish { reflection { 0, 1 fresnel } }
  interior { ior 1.5 dispersion 1.05 dispersion_samples 9 }
}
sphere { <2, .7, 0>, .7 pigment { rgbf 1 } finish { reflection .1 } interior { ior 1.5 dispersion 1.1 } }
plane { y, -.01 pigment { checker White Gray30 scale .4 } }
plane { z, 5 pigment { gradient x color_map { [.5 White] [.5 Black] } scale .5 } }
