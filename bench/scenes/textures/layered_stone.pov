// Stone of two layers: turbulent grain below, dark and clear veins above.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "stage.inc"
Stage(
  texture {
    pigment {
      granite turbulence 0.6
      color_map {
        [0.00 rgb <0.70, 0.66, 0.60>] [0.25 rgb <0.80, 0.74, 0.66>] [0.50 rgb <0.60, 0.56, 0.55>]
        [0.75 rgb <0.45, 0.40, 0.42>] [1.00 rgb <0.25, 0.22, 0.24>]
      }
      scale <1.2, 2.0, 1.6> rotate <0, 0, 35>
    }
    finish { ambient 0.1 diffuse 0.75 }
  }
  texture {
    pigment {
      granite turbulence 0.3
      color_map {
        [0.00 rgbt <0.95, 0.92, 0.88, 0.30>] [0.20 rgbt <0.90, 0.85, 0.80, 0.80>]
        [0.50 rgbt <0.50, 0.30, 0.25, 0.95>] [1.00 rgbt <0.20, 0.10, 0.10, 0.40>]
      }
      scale 2.5 rotate <0, 20, -40>
    }
    finish { ambient 0.1 diffuse 0.75 specular 0.3 roughness 0.02 }
  }
)
