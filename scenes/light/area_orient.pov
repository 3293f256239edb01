// orient turns the disc of an area light toward each lit point.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3.4, -6> look_at <0, 0.4, 0> angle 46 }
plane { y, -0.5 pigment { rgb 0.9 } }
sphere { <-1.2, 0.3, 0>, 0.5 pigment { rgb <0.9, 0.3, 0.2> } }
box { <0.5, -0.5, -0.4>, <1.2, 0.7, 0.3> pigment { rgb <0.3, 0.5, 0.9> } }
light_source { <-3, 3, -1>, 1 area_light <3, 0, 0>, <0, 0, 3>, 5, 5 circular orient }
