// Eggs: narrow, wide, equal, without a top; turned and stretched, cut, clipped, cutting, inside out, and with surface
// coordinates.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.7, 5, -9> look_at <0, 0.9, 0> angle 46 }
light_source { <-6, 10, -12> rgb 1 }
background { rgb 0.25 }
#declare Egg = ovus { 0.8, 0.4 translate 0.8*y }
#declare Pear = ovus { 0.6, 1.05 translate 0.6*y }
object { Egg pigment { rgb <0.8, 0.5, 0.2> } translate <-3, 0, 1.4> }
object { Pear pigment { rgb <0.3, 0.6, 0.8> } finish { specular 0.5 } rotate 30*z translate <-0.9, 0, 2> }
ovus { 0.7, 0.7 pigment { rgb <0.5, 0.8, 0.3> } scale <1.2, 1, 0.7> rotate <20, -30, 0> translate <1.3, 0.7, 1.6> }
ovus { 0.8, 0 pigment { rgb <0.8, 0.3, 0.5> } translate <3.2, 0.8, 1.4> }
difference { object { Egg } box { <0, -1, -2>, <2, 1.3, 0> } pigment { rgb <0.9, 0.8, 0.4> } translate <-2.9, 0, -1> }
difference { box { <-0.8, 0, -0.8>, <0.8, 1.1, 0.8> } object { Pear scale 0.6 translate 0.2*y } object { Egg scale 0.6 translate <0.5, 0.5, -0.8> } pigment { rgb <0.5, 0.5, 0.9> } translate <-1, 0, -1.4> }
intersection { object { Pear } object { Egg inverse translate <0.2, 0.6, -0.8> } pigment { rgb <0.3, 0.8, 0.7> } translate <1.1, 0, -1.4> }
object { Pear clipped_by { plane { <0.3, 0.2, -1>, -0.2 inverse } } pigment { rgb <0.9, 0.4, 0.3> } translate <2.9, 0, -1> }
ovus { 0.5, 0.3 uv_mapping pigment { checker rgb 1, rgb <0.6, 0.1, 0.1> scale 0.125 } rotate 20*x translate <0.1, 0.4, -3> }
plane { y, 0 pigment { rgb 0.5 } }
