// A file of our own included twice, with a parameter and a macro from it.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2, -5> look_at <0, 0.3, 0> angle 48 }
light_source { <3, 6, -5> rgb 1 }
background { rgb <0.3, 0.35, 0.4> }

#declare Tint = rgb <0.9, 0.5, 0.3>;
#include "pawn.inc"
object { Pawn translate -0.8*x }
#declare Tint = rgb <0.4, 0.5, 0.9>;
#include "pawn.inc"
object { Pawn translate 0.8*x }
Row_of(Pawn, 5, 1.6)
plane { y, 0 pigment { rgb 0.6 } }
