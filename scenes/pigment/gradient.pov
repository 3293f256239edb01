// gradient along any axis, repeated, with hard and soft steps, and its frequency and phase.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.2, -6> look_at <0, 0.7, 0> angle 52 }
light_source { <-3, 5, -6> rgb 1 }

#declare Map = color_map { [0 rgb <0.9, 0.3, 0.2>] [0.4 rgb <0.95, 0.9, 0.4>] [0.4 rgb <0.2, 0.4, 0.7>] [1 rgb <0.8, 0.9, 1>] }
box { <-2.6, 0, 0>, <-1.6, 1.4, 0.5> pigment { gradient y color_map { Map } scale 1.4 } }
box { <-1.3, 0, 0>, <-0.3, 1.4, 0.5> pigment { gradient <1, 1, 0> color_map { Map } } }
sphere { <0.7, 0.7, 0>, 0.7 pigment { gradient x color_map { Map } frequency 3 phase 0.25 } }
sphere { <2.2, 0.7, 0>, 0.7 pigment { gradient z color_map { Map } scale 0.3 triangle_wave } }
plane { y, 0 pigment { gradient x color_map { [0 rgb 0.4] [1 rgb 0.8] } scale 0.7 rotate 30*y } }
