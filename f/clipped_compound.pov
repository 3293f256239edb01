// A union clipped by a CSG solid, and bounded_by { clipped_by }.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <1, 2.5, -4.5> look_at <0, 0, 0> angle 40 }
light_source { <-4, 6, -5> rgb 1 }
background { rgb <0.15, 0.2, 0.15> }

union {
  box { <-1.2, -0.8, -1.2>, <1.2, 0.8, 1.2> pigment { rgb <0.8, 0.75, 0.6> } }
  cylinder { -1.1*y, 1.1*y, 0.6 pigment { rgb <0.6, 0.3, 0.5> } }
  clipped_by {
    difference {
      sphere { 0, 1.4 }
      cylinder { <0.6, -2, -1>, <0.6, 2, -1>, 0.8 }
    }
  }
  bounded_by { clipped_by }
  rotate 30*y
}
