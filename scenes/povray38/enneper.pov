#version 3.8;
// The whole equation of Enneper's surface.
global_settings { assumed_gamma 1 }
#include "functions.inc"
camera { location <2, 2.5, -4> look_at <0, 0, 0.8> angle 42 }
light_source { <4, 8, -6>, rgb 1 }
light_source { <-6, -3, -4>, rgb 0.5 }
isosurface { function { f_enneper(x, y, z, 0.02) } contained_by { box { <-1.2, -1.2, 0.25>, <1.2, 1.2, 1.6> } } max_gradient 4 accuracy 0.0005 open
  pigment { rgb <0.9, 0.6, 0.3> } interior_texture { pigment { rgb <0.4, 0.6, 0.9> } finish { ambient 0.15 diffuse 0.7 } }
  finish { ambient 0.15 diffuse 0.7 } }
