// right and up stretch the picture: a mirrored right hand and an up that is not one.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.5, -5> right -1.8*x up 0.9*y angle 60 look_at <0.4, 0.5, 0> }
light_source { <-3, 6, -4> rgb 1 }
background { rgb <0.3, 0.3, 0.4> }
sphere { <-1, 0.6, 0>, 0.6 pigment { rgb <0.8, 0.3, 0.3> } }
box { <0.5, 0, -0.5>, <1.5, 1.2, 0.5> pigment { rgb <0.3, 0.7, 0.4> } }
plane { y, 0 pigment { checker rgb 0.75, rgb 0.5 } }
