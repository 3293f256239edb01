// Fog on the way of mirrored and refracted rays; a solid that is not hollow holds none.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <-6, 8, -6>, 1 }
background { rgb <0.2, 0.3, 0.6> }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.7, 0.4, 0.2> } finish { reflection 0.3 } }
sphere { <-1.3, 0.9, 0>, 0.9 pigment { rgb 0.1 } finish { reflection 0.8 } }
sphere { <0.7, 0.8, -0.8>, 0.7 pigment { rgbf 0.95 } interior { ior 1.4 } }
sphere { <2.2, 0.8, 0.5>, 0.7 pigment { rgbf 0.95 } hollow }
fog { distance 8 rgb <0.8, 0.75, 0.7> }
