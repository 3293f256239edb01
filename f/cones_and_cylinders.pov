// Cones and slanted cylinders as operands of each operation.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -7> look_at <0, 0, 0> angle 56 }
light_source { <4, 7, -6> rgb 1 }
background { rgb <0.85, 0.8, 0.75> }

difference {
  cone { -y, 1, y, 0.4 pigment { rgb <0.75, 0.35, 0.3> } }
  cone { <0, -0.1, 0>, 0, <0, 1.2, 0>, 0.4 pigment { rgb <0.95, 0.85, 0.4> } }
  cylinder { <-2, -0.5, -0.3>, <2, 0.1, 0.1>, 0.25 pigment { rgb 0.9 } }
  translate -2.2*x
}
intersection {
  cone { -y, 1.1, 1.4*y, 0 pigment { rgb <0.3, 0.5, 0.75> } }
  cone { y, 1.1, -1.4*y, 0 pigment { rgb <0.45, 0.7, 0.5> } }
}
intersection {
  cylinder { <-1.2, -0.6, 0>, <1.2, 0.6, 0>, 0.7 pigment { rgb <0.6, 0.45, 0.7> } }
  cylinder { <-1.2, 0.6, 0>, <1.2, -0.6, 0>, 0.7 pigment { rgb <0.9, 0.6, 0.4> } }
  translate 2.2*x
}
