// fade_power: 2, 6, a broken one, and one that is not positive, which does not fade.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -5> look_at <0, 0, 0> angle 44 }
light_source { <-5, 6, -5>, rgb 0.15 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <0.4, 0.3, 0.2>, 0.3 pigment { rgb <0.9, 0.5, 0.4> } }
light_source { <-1.2, 1, 0.8>, rgb <0.8, 0.5, 0.3> fade_distance 1 fade_power 2 }
light_source { <1.2, 1, 0.8>, rgb <0.3, 0.5, 0.8> fade_distance 1 fade_power 6 }
light_source { <0, 1, -1.2>, rgb <0.4, 0.7, 0.4> fade_distance 1 fade_power 1.5 }
light_source { <0, 4, 4>, rgb 0.1 fade_distance 1 fade_power 0 }
