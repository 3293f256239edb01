// Quadrics alone: ellipsoid, one-sheet and two-sheet hyperboloid, parabolic cylinder.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.5, -9> look_at <0, 0, 2> angle 56 }
light_source { <-5, 8, -8> rgb 1 }
background { rgb <0.35, 0.4, 0.5> }

quadric { <1, 2, 1>, <0, 0.5, 0>, 0, -1 pigment { rgb <0.8, 0.4, 0.3> } translate <-3.4, 0, 0> }
quadric { <1, -0.4, 1>, 0, 0, -0.2 clipped_by { box { -1.6, 1.6 } } pigment { rgb <0.5, 0.7, 0.3> } translate <-0.8, 0, 0> }
quadric { <1, -0.6, 1>, 0, 0, 0.15 clipped_by { sphere { 0, 2 } } pigment { rgb <0.7, 0.6, 0.9> } scale 0.6 translate <2, 0, 1> }
quadric { <0, 0, 0.05>, 0, <0, 1, 0>, 2 pigment { rgb <0.5, 0.45, 0.4> } translate 6*z }
