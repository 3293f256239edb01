// Normals of a fisheye camera are asked for at the angles of the picture, which go from -90 degrees round to 270.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { fisheye location <0, 0, -3> look_at 0 right x up y angle 77 normal { granite 0.2 scale 2 } }
light_source { <-5, 9, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, -1.5 pigment { checker rgb 1, rgb 0.3 } }
sphere { 0, 1 pigment { rgb <1, 0.2, 0.2> } }
