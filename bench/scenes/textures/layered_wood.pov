// Wood of two layers: rings below, a fine grain that lets them through above.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "stage.inc"
Stage(
  texture {
    pigment {
      wood turbulence 0.05
      color_map { [0.0 rgb <0.60, 0.38, 0.20>] [0.6 rgb <0.72, 0.50, 0.28>] [0.9 rgb <0.42, 0.24, 0.12>] [1.0 rgb <0.60, 0.38, 0.20>] }
      scale 0.25 rotate <4, 85, 3>
    }
    finish { ambient 0.1 diffuse 0.8 }
  }
  texture {
    pigment {
      bozo turbulence 0.4 octaves 4
      color_map {
        [0.0 rgbt <0.35, 0.18, 0.08, 0.45>] [0.4 rgbt <0.60, 0.38, 0.20, 0.90>]
        [0.7 rgbt <0.30, 0.15, 0.05, 0.60>] [1.0 rgbt <0.60, 0.38, 0.20, 1.00>]
      }
      scale <0.02, 0.02, 0.6> rotate <4, 85, 3>
    }
    finish { ambient 0.1 diffuse 0.8 phong 0.3 phong_size 40 }
  }
)
