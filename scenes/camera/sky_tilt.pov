// sky tilts the horizon; it must come before look_at.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <1, 2, -5> sky <0.4, 1, 0> look_at <0, 0.6, 0> angle 45 }
light_source { <-2, 6, -5> rgb 1 }
background { rgb <0.5, 0.6, 0.75> }
cone { 0, 0.7, 1.6*y, 0.1 pigment { rgb <0.8, 0.3, 0.3> } }
sphere { <-1.3, 0.5, 0>, 0.5 pigment { rgb <0.8, 0.8, 0.3> } }
plane { y, 0 pigment { checker rgb 0.8, rgb 0.45 } }
