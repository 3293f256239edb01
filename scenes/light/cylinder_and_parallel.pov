// A cylindrical light and a parallel one.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 4, -7> look_at <0, 0.3, 0> angle 48 }
light_source { <-3, 5, -2> rgb <1, 0.9, 0.5> cylinder point_at <-1.5, 0, 0> radius 0.6 falloff 1.1 tightness 5 }
light_source { <6, 5, -4> rgb <0.4, 0.5, 0.8> parallel point_at 0 }

sphere { <-1.5, 0.4, 0>, 0.4 pigment { rgb 0.9 } }
box { <0.8, 0, -0.3>, <1.4, 1, 0.3> pigment { rgb 0.9 } }
plane { y, 0 pigment { rgb 0.8 } }
