// A coat of plaster: the normal is bent by granite, the colour mottled by bozo with turbulence.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "stage.inc"
Stage(texture {
  pigment {
    bozo turbulence 0.5
    color_map { [0.0 rgb <0.85, 0.80, 0.70>] [1.0 rgb <0.70, 0.62, 0.50>] }
    scale 1.5
  }
  normal { granite 0.25 scale 2 }
  finish { ambient 0.1 diffuse 0.8 specular 0.1 roughness 0.1 }
})
