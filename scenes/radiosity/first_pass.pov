// One pass of rays before the picture, without bounces: its samples are POV-Ray's one by one.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 12 error_bound 1.8 nearest_count 2 pretrace_end 0.08 recursion_limit 1 always_sample off } }
camera { location <0, 1.6, -5> look_at <0, 1, 0> angle 50 }
light_source { <-1.5, 3.5, -2>, 0.9 }
#declare Plaster = finish { diffuse 0.8 }
plane { y, 0 pigment { rgb <0.8, 0.75, 0.6> } finish { Plaster } }
plane { x, -2.5 pigment { rgb <0.9, 0.3, 0.2> } finish { Plaster } }
plane { -x, -2.5 pigment { rgb <0.2, 0.35, 0.9> } finish { Plaster } }
plane { z, 3 inverse pigment { rgb 0.85 } finish { Plaster } }
plane { y, 4 pigment { rgb 0.9 } finish { Plaster } }
sphere { <0.3, 1, 0.5>, 1 pigment { rgb 0.9 } finish { Plaster } }
