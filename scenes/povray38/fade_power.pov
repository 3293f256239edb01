#version 3.8;
// Light that fades with a power of the distance alone: no fade_distance.
global_settings { assumed_gamma 1 }
camera { location <0, 4, -7> look_at <0, 0, 0> angle 50 }
light_source { <-2, 1.5, -1>, rgb <3, 2, 1> fade_power 2 }
light_source { <2, 1.5, -1>, rgb <0.8, 1.2, 2> fade_power 1 fade_distance 0 }
light_source { <0, 3, 2>, rgb <2, 2, 2> spotlight point_at 0 radius 15 falloff 25 fade_power 1.5 }
plane { y, 0 pigment { checker rgb 0.9, rgb 0.6 } finish { ambient 0 diffuse 0.8 } }
sphere { <-1, 0.5, 0>, 0.5 pigment { rgb 0.9 } finish { ambient 0 diffuse 0.7 specular 0.3 } }
box { <0.6, 0, -0.4>, <1.4, 0.8, 0.4> pigment { rgb 0.9 } finish { ambient 0 diffuse 0.8 } }
