// Granite in three tones, slightly shiny.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "stage.inc"
Stage(texture {
  pigment {
    granite
    color_map {
      [0.0 rgb <0.12, 0.11, 0.12>] [0.3 rgb <0.45, 0.40, 0.38>]
      [0.5 rgb <0.62, 0.55, 0.50>] [0.8 rgb <0.85, 0.80, 0.75>] [1.0 rgb 0.95]
    }
    scale 1.5
  }
  finish { ambient 0.1 diffuse 0.8 specular 0.2 roughness 0.03 }
})
