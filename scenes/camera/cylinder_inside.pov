// A camera of type `cylinder 3` starts its rays along a line, part of it below the floor: there is no fog there.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { cylinder 3 location <0, 0.6, -5> angle 60 up 6*y look_at 0.6*y }
light_source { <-5, 9, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
fog { distance 8 rgb <0.9, 0.6, 0.8> }
plane { y, -0.4 pigment { checker rgb 1, rgb 0.3 } }
sphere { <-0.6, 0, 0>, 1 pigment { rgb <1, 0.2, 0.2> } }
box { <-1, 1.4, -6>, <1, 2.2, -4> pigment { rgbf 0.9 } interior { ior 1.4 } }
