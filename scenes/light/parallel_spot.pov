// A parallel spotlight has no rim, and nothing lies before it that is behind the plane of its lamp.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0.4, 0> angle 50 }
light_source { <1.4, 1.2, 1.4>, rgb <1, 0.9, 0.7> spotlight parallel point_at <0, 0, 0> radius 10 falloff 20 tightness 3 }
light_source { <-5, 6, -5>, rgb 0.2 }
plane { y, -0.5 pigment { rgb 0.9 } }
sphere { <-1, 0.3, 0>, 0.7 pigment { rgb <0.9, 0.4, 0.3> } }
