// Dried mud: the cells of crackle, their edges by the form, moved a little.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "stage.inc"
Stage(texture {
  pigment {
    crackle form <-1, 1, 0>
    color_map { [0.0 rgb <0.08, 0.05, 0.03>] [0.08 rgb <0.35, 0.25, 0.15>] [0.6 rgb <0.70, 0.58, 0.40>] }
    scale 0.35
  }
  finish { ambient 0.1 diffuse 0.85 }
})
