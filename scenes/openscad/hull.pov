// OpenSCAD's hull: of balls a sphere_sweep, of discs cylinders and a box, of points an intersection of planes.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "stage.inc"
View(<0, 0, 2>, 38)

// hull() { sphere(4); translate([14,0,6]) sphere(2); }
sphere_sweep {
  linear_spline 2, <0, 0, 0>, 4, <14, 0, 6>, 2
  translate <-24, 0, 0>
  texture { Yellow }
}

// hull() of two discs of one size, a slot: two cylinders and the box between them.
#macro Slot(Length, Radius, Height)
  merge {
    cylinder { <0, 0, 0>, <0, 0, Height>, Radius }
    cylinder { <Length, 0, 0>, <Length, 0, Height>, Radius }
    box { <0, -Radius, 0>, <Length, Radius, Height> }
  }
#end
object { Slot(8, 4, 5) translate <-3, 0, -3> texture { Green } }

// hull() of points: one plane a face, which holds the points on one side.
intersection {
  #for (I, 0, 4)
    plane { <cos(2*pi*I/5), sin(2*pi*I/5), 0.5>, 5 }
  #end
  plane { -z, 3 }
  translate <21, 0, 0>
  texture { Yellow }
}
