#version 3.8;
// A negative radius turns a torus inside out, two of them turn it back; rings that cross themselves in CSG.
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at 0.2*y angle 62 }
light_source { <-4, 6, -6>, 1 }
intersection { box { <-1, -0.6, -1>, <1, 0.6, 1> } torus { -0.7, 0.3 } translate -2*x pigment { rgb <0.9, 0.5, 0.3> } }
torus { -0.6, -0.25 pigment { rgb <0.4, 0.8, 0.5> } finish { phong 0.5 } }
difference { torus { 0.5, 0.8 merge } plane { z, -0.1 } translate 2*x pigment { rgb <0.4, 0.5, 0.9> } }
difference { torus { 0.3, 0.5 difference } plane { z, 0 } translate <0, 1.2, 1> pigment { rgb <0.9, 0.9, 0.4> } }
