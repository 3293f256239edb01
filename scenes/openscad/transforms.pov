// OpenSCAD's transformations: the same numbers, written behind the object and read from left to right.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "stage.inc"
View(<10, 3, 2>, 24)

#declare Brick = box { <0, 0, 0>, <10, 4, 2> }

object { Brick texture { Yellow } }
object { Brick texture { Green } translate <15, 0, 0> rotate <0, 0, 30> }     // rotate([0,0,30]) translate([15,0,0])
object { Brick texture { Green } rotate <0, 0, 30> translate <15, 0, 0> }     // translate([15,0,0]) rotate([0,0,30])
object { Brick texture { Yellow } scale <1, -1, 3> translate <0, -6, 0> }     // translate([0,-6,0]) scale([1,1,3]) mirror([0,1,0])
