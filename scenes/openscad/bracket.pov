// A part as in OpenSCAD: an angle bracket with slots, ribs and countersunk holes, made by macros.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "stage.inc"
View(<0, 8, 12>, 62)

#declare Width = 40;
#declare Thick = 4;

#macro Screw_Hole(D)    // along z, head on top at 0
  union {
    cylinder { <0, 0, -20>, <0, 0, 1>, D/2 }
    cone { <0, 0, -D/2>, D/2, <0, 0, 0.001>, D }
  }
#end

#macro Rib(X)
  prism {
    linear_spline X - 1.5, X + 1.5, 4, <Thick - 0.1, Thick - 0.1>, <24, Thick - 0.1>, <Thick - 0.1, 24>, <Thick - 0.1, Thick - 0.1>
    matrix <0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0>    // outline in y and z, thickness along x
  }
#end

#declare Bracket = difference {
  union {
    box { <-Width/2, 0, 0>, <Width/2, 30, Thick> }
    box { <-Width/2, 0, 0>, <Width/2, Thick, 30> }
    object { Rib(-12) }
    object { Rib(12) }
  }
  object { Screw_Hole(4) translate <0, 20, Thick> }
  object { Screw_Hole(4) rotate <-90, 0, 0> translate <0, Thick, 20> }
  texture { Yellow }
}

object { Bracket rotate <0, 0, 180> translate <0, 26, 0> }
