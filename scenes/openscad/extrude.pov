// OpenSCAD's linear_extrude: a prism; with scale a conic prism, with twist a solid whose function turns.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "stage.inc"
View(<2, 0, 5>, 29)

// linear_extrude(10) polygon([[-6,-4],[6,-4],[6,0],[-2,0],[-2,6],[-6,6]]); the first point comes again at the end.
prism {
  linear_spline 0, 10, 7, <-6, -4>, <6, -4>, <6, 0>, <-2, 0>, <-2, 6>, <-6, 6>, <-6, -4>
  transform { Upright }
  translate <-14, 0, 0>
  texture { Yellow }
}

// linear_extrude(10, scale=0.4) square(10, center=true): a cone of squares from its apex, turned to end on top.
#declare S = 0.4;
prism {
  conic_sweep linear_spline S, 1, 5, <-5, -5>, <5, -5>, <5, 5>, <-5, 5>, <-5, -5>
  transform { Upright }
  translate <0, 0, -1>
  scale <1, 1, -10/(1 - S)>
  translate <3, 0, 0>
  texture { Green }
}

// linear_extrude(10, twist=90) square(8, center=true): |x| and |y| of the point turned back are at most 4.
isosurface {
  function { max(abs(x*cos(z*pi/20) - y*sin(z*pi/20)), abs(x*sin(z*pi/20) + y*cos(z*pi/20))) - 4 }
  max_gradient 2
  contained_by { box { <-6, -6, 0>, <6, 6, 10> } }
  translate <18, 0, 0>
  texture { Yellow }
}
