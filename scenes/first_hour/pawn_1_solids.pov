// First hour, pawn, step 1: a pawn of three plain solids on a floor.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3, -7> look_at <0, 1.2, 0> angle 32 }
light_source { <-5, 8, -6> rgb 1 }
background { rgb <0.55, 0.62, 0.70> }
plane { <0, 1, 0>, 0 pigment { rgb <0.60, 0.60, 0.58> } }

union {
  cylinder { <0, 0, 0>, <0, 0.3, 0>, 0.8 }          // foot
  cone { <0, 0.3, 0>, 0.6, <0, 1.7, 0>, 0.25 }      // body
  sphere { <0, 2, 0>, 0.5 }                         // head
  pigment { rgb <0.85, 0.70, 0.50> }
}
