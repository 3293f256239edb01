// In a scene that ends below version 3.7 the brightest channel tells how much of the filter counts as let through, for use_alpha's mirroring too.
#version 3.8;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 60 }
light_source { <-5, 6, -6>, 1 }
background { rgb <0.5, 0.6, 0.8> }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.4 } }
#declare Mirror = finish { diffuse 0.4 reflection 0.5 use_alpha phong 0.8 }
sphere { <-2, 0, 0>, 0.9 pigment { rgbf <0.3, 0.5, 0.7, 0.6> } finish { Mirror } }
sphere { 0, 0.9 pigment { rgbft <0.6, 0.3, 0.2, 0.5, 0.2> } finish { Mirror } }
sphere { <2, 0, 0>, 0.9 pigment { bozo color_map { [0 rgbf <0.9, 0.8, 0.2, 0.7>] [1 rgbt <0.3, 0.2, 0.2, 0.3>] } scale 0.4 } finish { Mirror reflection { 0.2, 0.7 fresnel } } interior { ior 1.4 } }
#version 3.6;
