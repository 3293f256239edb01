// angle sets the length of direction; look_at turns the camera afterwards.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { angle 70 location <2, 3, -4> look_at <0.3, 0.5, 0> }
light_source { <-2, 6, -5> rgb 1 }
background { rgb <0.4, 0.5, 0.6> }
box { 0, 1 pigment { rgb <0.8, 0.5, 0.3> } }
cylinder { <-1, 0, 0>, <-1, 1.5, 0>, 0.3 pigment { rgb <0.4, 0.6, 0.8> } }
plane { y, 0 pigment { checker rgb 0.8, rgb 0.5 } }
