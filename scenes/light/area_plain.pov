// An area light asked point by point: every one of its 5 by 3 points throws a shadow of its own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3.4, -6> look_at <0, 0.4, 0> angle 46 }
plane { y, -0.5 pigment { rgb 0.9 } }
sphere { <-1.2, 0.3, 0>, 0.5 pigment { rgb <0.9, 0.3, 0.2> } }
box { <0.5, -0.5, -0.4>, <1.2, 0.7, 0.3> pigment { rgb <0.3, 0.5, 0.9> } }
light_source { <-3, 5, -2>, 1 area_light <2, 0, 0>, <0, 0, 1.5>, 5, 3 }
