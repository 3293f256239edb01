// One white point light: hard shadows on the ground and of one solid on another.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -6> look_at <0, 0.4, 0> angle 48 }
light_source { <-5, 5, -3> rgb 1 }

sphere { <-1.3, 0.8, 0>, 0.8 pigment { rgb <0.8, 0.4, 0.3> } }
box { <0.4, 0, -0.6>, <1.6, 1.6, 0.6> pigment { rgb <0.4, 0.6, 0.8> } }
torus { 0.6, 0.1 rotate 60*x translate <0.2, 0.7, -1.2> pigment { rgb <0.8, 0.8, 0.3> } }
plane { y, 0 pigment { rgb 0.8 } }
