// Lathes of every spline: open ones, one with a hole, turned and stretched, cut, clipped, cutting, inside out, and with
// surface coordinates.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.7, 5.3, -9> look_at <0, 0.7, 0> angle 46 }
light_source { <-6, 10, -12> rgb 1 }
background { rgb 0.25 }
#declare Cup = lathe { linear_spline 6, <0, 0>, <0.9, 0>, <0.3, 0.6>, <1, 1.8>, <0.85, 1.8>, <0, 0.7> }
#declare Vase = lathe { cubic_spline 9, <0, -0.3>, <0.6, 0>, <1, 0.5>, <0.5, 1.2>, <0.7, 1.9>, <0.55, 1.9>, <0.35, 1.2>, <0.7, 0.5>, <0.4, 0.2> }
#declare Bulb = lathe { quadratic_spline 6, <1, -0.4>, <0, 0>, <0.9, 0.6>, <0.5, 1.2>, <0.3, 1.6>, <0, 1.7> }
#declare Ring = lathe { bezier_spline 8, <0.5, 0.3>, <0.5, -0.1>, <1, -0.1>, <1, 0.3>, <1, 0.3>, <1, 0.7>, <0.5, 0.7>, <0.5, 0.3> }
object { Cup pigment { rgb <0.8, 0.5, 0.2> } translate <-3.1, 0, 1.4> }
object { Vase pigment { rgb <0.3, 0.6, 0.8> } finish { specular 0.5 } rotate <-40, 0, 15> translate <-0.9, 0.3, 2> }
object { Bulb pigment { rgb <0.5, 0.8, 0.3> } scale <1.2, 1, 0.7> rotate -30*y translate <1.2, 0, 1.6> }
object { Ring pigment { rgb <0.8, 0.3, 0.5> } rotate <-50, 20, 0> translate <3.2, 0.2, 1.4> }
difference { object { Vase } box { <0, -1, -2>, <2, 3, 0> } pigment { rgb <0.9, 0.8, 0.4> } translate <-2.9, 0, -1> }
difference { box { <-0.8, 0, -0.8>, <0.8, 1.1, 0.8> } object { Bulb } object { Cup scale 0.6 translate <0.5, 0.8, -0.5> } pigment { rgb <0.5, 0.5, 0.9> } translate <-1, 0, -1.4> }
intersection { object { Bulb scale 1.2 } object { Ring inverse translate <0.5, 0.6, -0.4> } pigment { rgb <0.3, 0.8, 0.7> } translate <1.1, 0, -1.4> }
object { Cup clipped_by { plane { <0.3, 0.2, -1>, 0 inverse } } pigment { rgb <0.9, 0.4, 0.3> } interior_texture { pigment { rgb <0.3, 0.4, 0.9> } } translate <2.8, 0, -1> }
lathe { linear_spline 4, <0, 0>, <0.5, 0.3>, <0.4, 0.9>, <0, 1.2> uv_mapping pigment { checker rgb 1, rgb <0.6, 0.1, 0.1> scale 0.125 } rotate 20*x translate <0.1, 0.4, -3> }
plane { y, 0 pigment { rgb 0.5 } }
