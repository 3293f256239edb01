// A spotlight's tightness: how fast the light weakens away from the axis.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -5> look_at <0, 0, 0> angle 44 }
light_source { <-5, 6, -5>, rgb 0.15 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <0.4, 0.3, 0.2>, 0.3 pigment { rgb <0.9, 0.5, 0.4> } }
light_source { <0, 4, 0>, 1 spotlight point_at <0.3, 0, 0> radius 60 falloff 70 tightness 40 }
