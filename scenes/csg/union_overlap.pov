// Union of overlapping opaque solids, each with its own pigment.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.5, -6> look_at <0, 0.2, 0> angle 40 }
light_source { <-4, 7, -5> rgb 1 }
background { rgb <0.15, 0.15, 0.2> }

union {
  sphere { <-0.8, 0.3, 0>, 0.9 pigment { rgb <0.8, 0.25, 0.2> } }
  box { <-0.6, -0.6, -0.6>, <0.9, 0.6, 0.6> pigment { rgb <0.9, 0.8, 0.3> } }
  cylinder { <0.6, -0.8, 0.1>, <1.3, 1.3, 0.1>, 0.4 pigment { rgb <0.3, 0.6, 0.35> } }
  cone { <-1.9, -0.8, 0.4>, 0.5, <-1.5, 1.2, -0.6>, 0.1 pigment { rgb <0.3, 0.4, 0.8> } }
}
plane { y, -0.8 pigment { rgb 0.6 } }
