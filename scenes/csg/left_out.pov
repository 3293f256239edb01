// Operands of merges and differences that are made of inverted half spaces: rays that miss the box of such an operand are not within it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.4, -6> look_at <0, 0, 0> angle 50 }
light_source { <-4, 5, -6> rgb 1 }
light_source { <5, -3, -4> rgb 0.4 }
background { rgb 0.2 }
#declare Slab = intersection { plane { y, 1 inverse } plane { -y, -1.3 inverse } }
intersection {
  merge {
    sphere { <-1.6, 0, 0>, 1.2 }
    sphere { <0.3, 0, 0>, 1 }
    object { Slab }
  }
  box { <-3, -1.5, -2>, <1.2, 1.5, 2> }
  pigment { rgb <0.8, 0.5, 0.3> }
}
difference {
  merge {
    cylinder { <2, -1.4, 0>, <2, 1.4, 0>, 0.7 }
    intersection { plane { y, -0.4 inverse } plane { -y, -0.2 inverse } plane { x, 1.1 inverse } plane { -x, -2.9 inverse } plane { z, -0.9 inverse } plane { -z, -0.9 inverse } }
  }
  intersection { plane { y, 0.5 inverse } plane { -y, -0.8 inverse } }
  sphere { <2, -1, -0.7>, 0.4 }
  pigment { rgb <0.4, 0.6, 0.8> }
}
