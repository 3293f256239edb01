// Surfaces of revolution: closed, open, turned and stretched, cut, clipped, cutting, inside out, and with surface coordinates.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.7, 5.3, -9> look_at <0, 0.7, 0> angle 44 }
light_source { <-6, 10, -12> rgb 1 }
background { rgb 0.25 }
#declare Vase = sor { 6, <0.2, -0.5>, <0.5, 0>, <1, 0.6>, <0.4, 1.4>, <0.6, 1.8>, <0.9, 2> }
#declare Drop = sor { 5, <0.6, -0.1>, <0, 0>, <0.8, 0.6>, <0, 1.6>, <0.1, 2> }
object { Vase pigment { rgb <0.8, 0.5, 0.2> } translate <-3, 0, 1.4> }
sor { 6, <0.2, -0.5>, <0.5, 0>, <1, 0.6>, <0.4, 1.4>, <0.6, 1.8>, <0.9, 2> open pigment { rgb <0.3, 0.6, 0.8> } interior_texture { pigment { rgb <0.8, 0.3, 0.2> } } rotate <-50, 0, 10> translate <-1, 0.3, 2> }
object { Drop pigment { rgb <0.5, 0.8, 0.3> } finish { specular 0.5 } scale <1.2, 1, 0.7> rotate -30*y translate <1.2, 0, 1.6> }
object { Drop pigment { rgb <0.8, 0.3, 0.5> } rotate <30, 20, 100> translate <3.6, 0.8, 1.4> }
difference { object { Vase } box { <0, -1, -2>, <2, 3, 0> } sphere { <0, 1.9, 0>, 0.5 } pigment { rgb <0.9, 0.8, 0.4> } translate <-2.8, 0, -1> }
difference { box { <-0.8, 0, -0.8>, <0.8, 1.1, 0.8> } object { Drop } object { Vase scale 0.5 translate <0.5, 0.5, -0.6> } pigment { rgb <0.5, 0.5, 0.9> } translate <-1, 0, -1.4> }
intersection { object { Vase } object { Drop inverse translate <0.2, 0.3, -0.6> } pigment { rgb <0.3, 0.8, 0.7> } translate <1.1, 0, -1.4> }
object { Vase clipped_by { plane { <0.3, 0.2, -1>, 0 inverse } } pigment { rgb <0.9, 0.4, 0.3> } translate <2.9, 0, -1> }
sor { 4, <0.1, -0.5>, <0.3, 0>, <0.5, 0.7>, <0.2, 1> uv_mapping pigment { checker rgb 1, rgb <0.6, 0.1, 0.1> scale 0.125 } rotate -60*x translate <0.1, 0.4, -3> }
plane { y, 0 pigment { rgb 0.5 } }
