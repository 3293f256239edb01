// A box with a bore: six flat faces, one round one, two round edges.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Bored = difference { box { -1, 1 } cylinder { -2 * y, 2 * y, 0.5 } }
object { Bored }
