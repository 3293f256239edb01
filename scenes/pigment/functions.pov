// Patterns made of functions: formulas, the internal library, other patterns and pigments; as colour, as normal, wrapped
// above 1 and below 0.
#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 48 }
light_source { <-20, 30, -40> rgb 1 }

#declare Cells = function { pattern { cells scale 0.4 } }
#declare Stripes = function { pigment { gradient x color_map { [0 rgb <1, 0.2, 0>] [1 rgb <0, 0.4, 1>] } scale 0.7 } }
#declare Turn = function { transform { rotate 40*z scale 0.5 } }
#declare Wave = function(a, b) { sin(a * 4) * cos(b * 3) }
#declare Curve = function { spline { natural_spline -1, <0, 0> 0, <1, 0.2> 1, <0.2, 1> } }
#declare Map = color_map { [0 rgb <0.9, 0.9, 0.7>] [0.3 rgb <0.2, 0.6, 0.3>] [0.7 rgb <0.1, 0.2, 0.6>] [1 rgb <0.8, 0.1, 0.1>] }

#macro Tile(Column, Row)
  translate <Column * 2.2 - 3.3, Row * 2.2 - 1.1, 0>
#end

box { -1, 1 pigment { function { x * 1.7 + abs(y) } color_map { Map } } Tile(0, 0) }
box { -1, 1 pigment { function { Wave(x, y) + 0.5 } color_map { Map } turbulence 0.2 } Tile(1, 0) }
box { -1, 1 pigment { function { f_noise3d(x * 3, y * 3, z * 3) } color_map { Map } } Tile(2, 0) }
box { -1, 1 pigment { function { Cells(x, y, z) * 0.5 + Stripes(x, y, z).red * 0.5 } color_map { Map } triangle_wave frequency 2 } Tile(3, 0) }
box { -1, 1 pigment { function { select(x, Curve(y).x, sum(i, 1, 3, abs(sin(i * y)) / 3)) } color_map { Map } } Tile(0, 1) }
box { -1, 1 pigment { function { mod(Turn(x, y, z).x * 5, 1) } color_map { Map } } Tile(1, 1) }
sphere { 0, 1.05 pigment { rgb <0.8, 0.7, 0.5> } normal { function { f_ridged_mf(x * 2, y * 2, z * 2, 0.4, 2.1, 5, 0.8, 2, 2) } 0.6 } finish { phong 0.6 } Tile(2, 1) }
sphere { 0, 1.05 pigment { rgb 0.8 } normal { function { f_hex_x(x * 5, y * 5, 0, 0) } 0.8 } finish { specular 0.5 } Tile(3, 1) }
