// POV-Ray remembers what last cast a shadow and asks that, but not its box, first: from the first shadowed point on, here in the upper left corner, a plane
// casts its shadow beyond the box that its clip turned inside out gives it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <1.2, 5, -0.9> right 3.2*x up 2.4*y look_at <1.2, 0, -0.9> }
light_source { <0, 50, 0> rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.8, 0.5> rgb <0.4, 0.5, 0.3> scale 0.4 } }
plane { <0.2, 1, 0.1>, 0 clipped_by { sphere { <-0.05, 0, -0.15>, 0.5 inverse } } translate 0.1*x no_image }
