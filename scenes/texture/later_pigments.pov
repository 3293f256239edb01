// A pigment that comes after another and after a move: the move is done with, whatever the first one was.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z right 6.4*x up 4.8*y look_at 0 }
light_source { <3, 5, -10> rgb 1 }
#macro Ball(I) sphere { 0, 0.7 } #end

// A pattern, a plain colour, a pattern.
object { Ball(0) pigment { marble scale 0.3 } translate <-2, 1.2, 0> pigment { rgb 1 } pigment { radial } }
// The same without the first pattern.
object { Ball(0) pigment { rgb 1 } translate <0, 1.2, 0> pigment { radial } }
// A copy turned between both.
#declare Moved = sphere { 0, 0.7 pigment { marble scale 0.3 } translate <1.6, 1, 0> }
object { Moved pigment { rgb 1 } rotate 7*z pigment { radial } }
// Moves before and behind.
object { Ball(0) pigment { wood scale 0.2 } translate <-2, -1, 0> pigment { rgb 1 } translate -0.2*y pigment { gradient x } scale <1, 1.1, 1> }
// Kept from the first: its map.
object { Ball(0) pigment { marble color_map { [0 rgb x] [1 rgb y] } } translate <0, -1.2, 0> pigment { color_map { [0 rgb z] [1 rgb 1] } } }
object { Ball(0) pigment { leopard scale 0.1 } translate <2, -1.2, 0> pigment { rgb 0.5 } pigment { checker scale 0.3 } }
