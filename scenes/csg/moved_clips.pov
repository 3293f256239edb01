// Planes that were transformed after they had got clips have for POV-Ray the box of the first clip, one turned inside out too: nothing
// is seen beyond it. The left one was not transformed since.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.8, 1.1, -9> look_at 0 angle 46 }
light_source { <-5, 9, -8> rgb 1 shadowless }
background { rgb <0.3, 0.5, 0.8> }
#default { pigment { checker rgb <0.9, 0.8, 0.5> rgb <0.4, 0.5, 0.3> scale 0.4 } }
plane { <-0.2, 1, -0.3>, 0 clipped_by { sphere { 0, 0.9 inverse } } translate <1.6, 1, 0> }
plane { <-0.2, 1, -0.3>, 0 translate <-1.8, 1, 0> clipped_by { box { <-2.8, 0, -1>, <-0.8, 2, 1> } } }
plane { <-1, -0.7, -0.8>, 0.3 clipped_by { cylinder { -z, z, 0.4 inverse } sphere { 0, 1 } } translate <-2, -1.4, 0> }
merge { plane { <-1, -0.7, -0.8>, 0.3 clipped_by { sphere { <-0.1, -0.2, 0>, 0.9 inverse } } translate -0.3*x } translate <1.6, -1.6, 0> }
