// What a ray of an orthographic camera starts inside of is asked for each: fog ends where the floor's inside begins, and glass
// that some rays start in bends them once.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { orthographic location <0, 0, -4> right x*8 up y*6 look_at 0 }
light_source { <-5, 9, -5> rgb 1 }
light_source { <5, 3, -9> rgb 0.5 }
background { rgb <0.3, 0.5, 0.8> }
fog { distance 8 rgb <0.9, 0.6, 0.8> }
plane { y, -2.2 pigment { checker rgb 1, rgb 0.3 } }
plane { z, 9 pigment { gradient y color_map { [0 rgb 1] [1 rgb <1, 0.2, 0>] } } hollow }
sphere { <-2, 0, -4>, 1.4 pigment { rgbf 0.9 } interior { ior 1.5 fade_distance 1 fade_power 2 fade_color <0.3, 0.8, 0.4> } }
box { <1, -1, -5>, <3, 1, -2> pigment { rgbf 0.9 } hollow interior { ior 1.3 } }
difference {
    sphere { <0, 2, -4>, 1 }
    box { <-2, 1, -5>, <0, 4, -2> }
    pigment { rgbt 0.8 } interior { ior 1.1 } finish { reflection { 0.1, 0.4 fresnel } conserve_energy }
}
torus { 0.6, 0.2 rotate 90*x translate <0, -1, -4> pigment { rgbf 0.7 } hollow interior { ior 1.2 } }
sphere { 0, 0.6 pigment { rgb <1, 0.2, 0.2> } }
