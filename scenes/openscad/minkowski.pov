// OpenSCAD's minkowski with a ball: edges are rounded; a box of balls, cylinders and boxes, or one rounded by a power.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "stage.inc"
View(<0, 0, 0>, 30)

// minkowski() { cube([12,8,6], center=true); sphere(2); }: eight balls, twelve cylinders, three boxes.
#macro Rounded_Cube(Size, R)
  #local H = Size/2;
  merge {
    #for (I, -1, 1, 2)
      #for (J, -1, 1, 2)
        #for (K, -1, 1, 2) sphere { <I*H.x, J*H.y, K*H.z>, R } #end
        cylinder { <-H.x, I*H.y, J*H.z>, <H.x, I*H.y, J*H.z>, R }
        cylinder { <I*H.x, -H.y, J*H.z>, <I*H.x, H.y, J*H.z>, R }
        cylinder { <I*H.x, J*H.y, -H.z>, <I*H.x, J*H.y, H.z>, R }
      #end
    #end
    box { -H - R*x, H + R*x }
    box { -H - R*y, H + R*y }
    box { -H - R*z, H + R*z }
  }
#end
object { Rounded_Cube(<12, 8, 6>, 2) translate <-9, 0, 0> texture { Yellow } }

// Softer corners everywhere, from one solid.
superellipsoid { <0.3, 0.3> scale <6, 5, 5> translate <11, 0, 0> texture { Green } }
