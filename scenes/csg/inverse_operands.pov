// `inverse` swaps inside and outside: an intersection with inverted solids is a difference.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <1.5, 3, -5> look_at <0, -0.2, 0> angle 42 }
light_source { <-2, 6, -6> rgb 1 }

intersection {
  box { -1, 1 }
  sphere { <-0.9, 1, -0.6>, 0.9 inverse pigment { rgb <0.9, 0.5, 0.1> } }
  cylinder { <0.5, -2, -0.3>, <0.5, 2, -0.3>, 0.4 inverse pigment { rgb <0.2, 0.6, 0.8> } }
  plane { <1, 1, 1>, -1.1 inverse pigment { rgb <0.8, 0.2, 0.5> } }
  pigment { rgb 0.8 }
}
difference {
  plane { y, -1 }
  box { <-0.5, -2, -0.5>, <0.5, 0, 0.5> inverse scale <5, 1, 5> translate 1*z }
  pigment { rgb <0.4, 0.5, 0.4> }
}
