// OpenSCAD's modules: a macro with parameters, and one that takes an object where a module takes children.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "stage.inc"
View(<0, 0, 0>, 32)

#macro Tube(Height, Outer, Inner)
  difference {
    cylinder { <0, 0, 0>, <0, 0, Height>, Outer }
    cylinder { <0, 0, -1>, <0, 0, Height + 1>, Inner }
  }
#end

#macro Corners(Thing, A, B)
  union {
    #for (I, -1, 1, 2)
      #for (J, -1, 1, 2)
        object { Thing translate <I*A, J*B, 0> }
      #end
    #end
  }
#end

object { Tube(10, 5, 3.5) texture { Yellow } }
#declare Post = object { Tube(6, 2, 1) texture { Green } }
object { Corners(Post, 14, 8) }
