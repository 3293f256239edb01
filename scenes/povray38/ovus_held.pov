#version 3.8;
// Eggs with the larger sphere on top in CSG: both spheres are inside, though the lower one is not drawn.
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> look_at <0, 0.3, 0> angle 50 }
light_source { <-4, 6, -6>, 1 }
#declare Egg = ovus { 0.6, 0.65 distance 0.8 pigment { rgb <0.9, 0.8, 0.5> } }
difference { object { Egg } plane { z, -0.1 pigment { rgb <0.5, 0.7, 0.9> } } translate <-1.7, -0.2, 0> }
intersection { object { Egg } sphere { <-0.3, -0.1, -0.4>, 0.9 pigment { rgb <0.8, 0.4, 0.4> } } translate -0.2*y }
merge { object { Egg } sphere { <0, 0, -0.4>, 0.5 } translate <1.6, -0.2, 0> pigment { rgbt <0.6, 0.9, 0.7, 0.5> } }
plane { y, -1 pigment { checker rgb 0.4 rgb 0.7 } }
