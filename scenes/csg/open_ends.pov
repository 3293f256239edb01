// Open cylinders and cones draw no caps; in CSG they bound the same set as the closed ones.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3.4, -6.5> look_at <0, 0, 0> angle 56 }
light_source { <-3, 8, -6> rgb 1 }
background { rgb <0.2, 0.22, 0.28> }

cylinder { <-2.2, -0.8, 0>, <-2.2, 0.8, 0>, 0.7 open pigment { rgb <0.9, 0.4, 0.3> } }
cone { <-0.6, -0.8, 0>, 0.8, <-0.6, 0.8, 0>, 0.45 open pigment { rgb <0.4, 0.8, 0.4> } }
// cut from a box with no caps of its own in the way
difference {
  box { <0.4, -0.8, -0.6>, <1.6, 0.8, 0.6> }
  cylinder { <1, 0, 0>, <1, 2, 0>, 0.45 open pigment { rgb <0.3, 0.5, 0.9> } }
  pigment { rgb <0.9, 0.8, 0.5> }
}
intersection {
  cylinder { <2.4, -0.8, 0>, <2.4, 0.8, 0>, 0.7 open }
  plane { <0.7, 1, -0.6>, 1.3 pigment { rgb 0.9 } }
  pigment { rgb <0.7, 0.4, 0.8> }
}
