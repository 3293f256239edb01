// Veined marble with its usual turbulence.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "stage.inc"
Stage(texture {
  pigment {
    marble turbulence 0.8
    color_map { [0.0 rgb 0.95] [0.6 rgb <0.75, 0.76, 0.80>] [0.9 rgb <0.25, 0.25, 0.32>] [1.0 rgb <0.1, 0.1, 0.15>] }
    scale 0.7 rotate <20, 30, 40>
  }
  finish { ambient 0.1 diffuse 0.8 specular 0.4 roughness 0.02 }
})
