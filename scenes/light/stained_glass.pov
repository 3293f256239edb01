// Light through panes of pictures and patterns, from an area light and through smoke from a spotlight: what each shadow
// ray is left with is found for a whole tile.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 3.2, -6.5> look_at <0, 0.8, 0> angle 46 }
light_source { <-4, 7, -3> rgb <0.9, 0.85, 0.8> area_light <1.6, 0, 0>, <0, 0, 1.6>, 4, 4 }
light_source { <2.2, 5, 0.4> rgb 1.2 spotlight point_at <1.4, 0, 0> radius 14 falloff 18 }
plane { y, 0 pigment { rgb 0.9 } hollow }
#declare Pane = pigment {
  image_map { function 40, 40 { pigment { function { mod(floor(x * 5) + floor(y * 3), 2) } color_map { [0 rgb <0.9, 0.2, 0.1>][1 rgb <0.1, 0.4, 0.9>] } } } once filter all 0.85 }
}
box { <-2.2, 0.1, -0.04>, <-1, 1.5, 0.04> pigment { Pane translate <-1.7, 0, 0> scale <1.1, 1.2, 1> } }
box { <-0.8, 0.1, -0.04>, <0.2, 1.5, 0.04> pigment { granite scale 0.8 color_map { [0.2 rgbf <1, 0.8, 0.1, 0.9>][0.6 rgbf <0.1, 0.8, 0.4, 0.7>] } } interior { ior 1.4 caustics 0.4 } }
sphere { <-0.3, 2, 0.3>, 0.35 pigment { checker rgbf <1, 0.5, 0.9, 0.8> rgbt 1 scale 0.2 } }
polygon { 5, <-0.5, -0.5>, <0.5, -0.5>, <0.5, 0.5>, <-0.5, 0.5>, <-0.5, -0.5> pigment { Pane translate <-0.5, -0.5, 0> } rotate 80 * x translate <1.7, 2, 0.2> hollow }
box { <0.7, 0.001, -0.7>, <2.2, 1.6, 0.8> pigment { rgbf 1 } hollow interior { media { scattering { 1, rgb 0.25 } intervals 1 samples 6 method 3 } } }
