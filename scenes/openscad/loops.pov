// OpenSCAD's for: a ring of posts, higher and higher, and a list of values from an array.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "stage.inc"
View(<0, 0, 5>, 36)

union {
  #for (A, 0, 359, 30)
    cylinder { <12, 0, 0>, <12, 0, 2 + A/30>, 2 rotate <0, 0, A> }
  #end
  texture { Yellow }
}

#declare Sizes = array[3] { 5, 3, 1.5 }
#declare Z = 0;
#for (I, 0, 2)
  box { <-1, -1, 0>*Sizes[I], <1, 1, 1>*Sizes[I] translate <0, 0, Z> texture { Green } }
  #declare Z = Z + Sizes[I];
#end
