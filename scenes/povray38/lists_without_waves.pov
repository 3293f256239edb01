#version 3.8;
// What stands in lists has no frequency, phase or wave: each pair of tiles is the same.
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> look_at 0 right 4*x up 3*y }
light_source { <-3, 4, -8>, 1 }
#macro Tile(X, Y, Colors) box { <X, Y, 0>, <X + 0.9, Y + 1.2, 1> pigment { Colors translate <X, Y, 0> } } #end
#declare A = rgb <0.9, 0.5, 0.2>; #declare B = rgb <0.2, 0.4, 0.7>; #declare C = rgb <0.8, 0.9, 0.5>;
Tile(-1.95, 0.1, pigment { checker A, B scale 0.3 })
Tile(-0.95, 0.1, pigment { brick A, B scale 0.07 })
Tile(0.05, 0.1, pigment { hexagon A, B, C rotate 90*x scale 0.2 })
Tile(1.05, 0.1, pigment { object { sphere { <0.4, 0.6, 0>, 0.3 } A, B } })
Tile(-1.95, -1.4, pigment { checker A, B scale 0.3 frequency 1 phase 0.3 })
Tile(-0.95, -1.4, pigment { brick A, B scale 0.07 sine_wave })
Tile(0.05, -1.4, pigment { hexagon A, B, C rotate 90*x scale 0.2 triangle_wave })
Tile(1.05, -1.4, pigment { object { sphere { <0.4, 0.6, 0>, 0.3 } A, B } frequency 1 phase 0.4 })
