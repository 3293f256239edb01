// fade_distance without a power to speak of: the distance at which the light has its own colour.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -5> look_at <0, 0, 0> angle 44 }
light_source { <-5, 6, -5>, rgb 0.15 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <0.4, 0.3, 0.2>, 0.3 pigment { rgb <0.9, 0.5, 0.4> } }
light_source { <-1, 1.5, 0>, rgb <0.8, 0.6, 0.4> fade_distance 0.8 fade_power 1 }
light_source { <1.5, 1.5, 0>, rgb <0.4, 0.6, 0.8> fade_distance 3 fade_power 1 }
