// Ripples and waves of sixty sources: a sine and a square root for each of them at every point.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 0.45 s, Whittle 0.19 s.
#version 3.7;
global_settings { assumed_gamma 1 number_of_waves 60 }
camera { location <0, 2, -6> look_at <0, 0, 1> angle 45 }
light_source { <-6, 8, 7>, 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb <.2, .4, .8>] } } }
plane { y, -1 pigment { rgb <.1, .3, .4> } normal { waves .3 frequency 4 scale .5 } finish { reflection .5 } }
sphere { <0, 0, 2>, 1 pigment { ripples frequency 3 color_map { [0 rgb <.8, .4, .2>] [1 rgb 1] } } }
sphere { <2.2, 0, 2>, 1 pigment { waves frequency 3 color_map { [0 rgb <.8, .4, .2>] [1 rgb 1] } } }
