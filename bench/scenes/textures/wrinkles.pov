// Wrinkled leather.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "stage.inc"
Stage(texture {
  pigment {
    wrinkles
    color_map { [0.2 rgb <0.25, 0.12, 0.06>] [0.5 rgb <0.55, 0.30, 0.15>] [0.9 rgb <0.80, 0.55, 0.30>] }
    scale 0.5
  }
  finish { ambient 0.1 diffuse 0.8 phong 0.3 phong_size 25 }
})
