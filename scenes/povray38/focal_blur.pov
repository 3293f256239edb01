#version 3.8;
// Few samples of focal blur: which rays go through the lens for each pixel shows in the grain.
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at <0, 0.4, 0> angle 50 aperture 0.8 focal_point <0, 0.5, 0> blur_samples 7 variance 0 }
light_source { <-4, 8, -6>, rgb 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.2 scale 0.7 } finish { ambient 0.1 diffuse 0.7 } }
sphere { <0, 0.5, 0>, 0.5 pigment { gradient x color_map { [0.5 rgb x] [0.5 rgb y] } scale 0.2 } finish { ambient 0.1 diffuse 0.7 } }
cylinder { <1, 0, 3>, <1, 2, 3>, 0.2 pigment { rgb <0.2, 0.5, 0.9> } finish { ambient 0.1 diffuse 0.7 } }
cylinder { <-0.9, 0, -2.5>, <-0.9, 2, -2.5>, 0.1 pigment { rgb <0.9, 0.8, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
