// No look_at and no angle: location, direction, right and up as vectors, transformed at the end.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0.7, -3> direction <0, 0, 1.2> right <1.33, 0, 0> up <0, 1, 0> rotate <15, -30, 0> }
light_source { <-2, 6, -5> rgb 1 }
background { rgb <0.4, 0.5, 0.6> }
box { <-0.5, 0, -0.5>, <0.5, 1, 0.5> pigment { rgb <0.8, 0.5, 0.3> } }
sphere { <1.2, 0.4, 0.5>, 0.4 pigment { rgb <0.4, 0.6, 0.8> } }
plane { y, 0 pigment { checker rgb 0.8, rgb 0.5 } }
