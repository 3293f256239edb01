// OpenSCAD's rotate_extrude: a lathe, of straight lines or of curves; a torus; a part of a turn by a cut.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "stage.inc"
View(<1, 0, 4>, 36)

// rotate_extrude() polygon([[3,0],[8,0],[8,2],[5,2],[5,10],[3,10]]);
#declare Bush = lathe {
  linear_spline 7, <3, 0>, <8, 0>, <8, 2>, <5, 2>, <5, 10>, <3, 10>, <3, 0>
  transform { Upright }
}
object { Bush texture { Yellow } translate <-14, 0, 0> }

// A vase: a Bezier curve needs no $fn.
lathe {
  bezier_spline 8, <0, 0>, <9, 0>, <9, 6>, <3, 8>, <3, 8>, <2, 9>, <4, 11>, <0, 11>
  transform { Upright }
  translate <4, 0, 0>
  texture { Green }
}

// rotate_extrude(angle=270) translate([6,0]) circle(2): a torus less a quarter.
difference {
  torus { 6, 2 transform { Upright } }
  box { <0, -20, -3>, <20, 0, 3> }
  translate <20, 0, 3>
  texture { Yellow }
}
