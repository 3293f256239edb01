// Intersection of a solid with each operand that bounds nothing.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "surface_operands.inc"
#macro Pair(A, B) intersection { object { A } object { B } } #end
Pairs()
