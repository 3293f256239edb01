// Cylinder lights: radius and falloff are lengths; tightness weakens away from the axis.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -5> look_at <0, 0, 0> angle 44 }
light_source { <-5, 6, -5>, rgb 0.15 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <0.4, 0.3, 0.2>, 0.3 pigment { rgb <0.9, 0.5, 0.4> } }
light_source { <-1.2, 4, 0>, rgb <1, 0.7, 0.5> cylinder point_at <-1.2, 0, 0> radius 0.3 falloff 0.9 tightness 0 }
light_source { <1.2, 4, 0>, rgb <0.5, 0.7, 1> cylinder point_at <1, 0, 0> radius 0.9 falloff 1 tightness 4 }
