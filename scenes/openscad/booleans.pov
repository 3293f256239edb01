// OpenSCAD's booleans: union, difference and intersection of a cube and a ball.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "stage.inc"
View(<0, 0, 0>, 30)

#declare Cube = box { <-5, -5, -5>, <5, 5, 5> texture { Yellow } }
#declare Ball = sphere { <0, 0, 0>, 6.5 texture { Green } }

union { object { Cube } object { Ball } translate <-16, 0, 0> }
difference { object { Cube } object { Ball } }
intersection { object { Cube } object { Ball } translate <16, 0, 0> }
