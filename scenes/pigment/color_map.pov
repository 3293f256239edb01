// Maps that start late, end early, hold steps and carry filter.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.2, -6> look_at <0, 0.7, 0> angle 52 }
light_source { <-3, 5, -6> rgb 1 }

plane { -z, -2 pigment { checker rgb 0.9, rgb 0.5 scale 0.5 } }
box { <-2.4, 0, 0>, <-1.2, 1.4, 0.3> pigment { gradient y color_map { [0.3 rgb <0.9, 0.3, 0.3>] [0.7 rgb <0.3, 0.3, 0.9>] } scale 1.4 } }
box { <-0.8, 0, 0>, <0.6, 1.4, 0.1> pigment { gradient x color_map { [0 rgbf <1, 0.8, 0.3, 0.9>] [0.5 rgb <0.9, 0.5, 0.3>] [0.5 rgbt <0.3, 0.6, 0.4, 0.8>] [1 rgbft <0.5, 0.6, 0.9, 0.3, 0.3>] } scale 0.7 } }
sphere { <1.7, 0.7, 0>, 0.7 pigment { gradient y color_map { [0.2 color rgb 1] [0.2 color rgb <0.8, 0.2, 0.4>] [0.6 color rgb <0.8, 0.6, 0.2>] [0.8 color rgb <0.1, 0.3, 0.3>] } scale 0.5 } }
