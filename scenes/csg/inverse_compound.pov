// An inverted difference as an operand: cuts away all but its own shape.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <2.2, 2.2, -3.4> look_at 0 angle 40 }
light_source { <3, 6, -4> rgb 1 }
background { rgb <0.25, 0.3, 0.35> }

#declare Shell = difference {
  sphere { 0, 1.3 pigment { rgb <0.3, 0.7, 0.4> } }
  sphere { 0, 1.05 pigment { rgb <0.9, 0.8, 0.2> } }
}
difference {
  box { -1, 1 pigment { rgb <0.7, 0.3, 0.3> } }
  object { Shell inverse }
  plane { <-1, 0.3, 1>, -0.5 pigment { rgb <0.3, 0.3, 0.8> } }
}
