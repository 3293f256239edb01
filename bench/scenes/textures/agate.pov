// Bands of agate.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "stage.inc"
Stage(texture {
  pigment {
    agate agate_turb 1.1
    color_map {
      [0.0 rgb <0.95, 0.93, 0.90>] [0.4 rgb <0.75, 0.50, 0.35>]
      [0.6 rgb <0.45, 0.20, 0.12>] [0.9 rgb <0.80, 0.75, 0.70>] [1.0 rgb 1]
    }
    scale 0.8
  }
  finish { ambient 0.1 diffuse 0.7 phong 0.5 phong_size 60 }
})
