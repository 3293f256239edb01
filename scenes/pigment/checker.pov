// checker in its own space: scaled, rotated, on a plane, on a sphere and on boxes whose faces lie on cell edges.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.5, -5> look_at <0, 0.4, 0> angle 52 }
light_source { <-4, 6, -4> rgb 1 }

plane { y, 0 pigment { checker rgb <0.8, 0.8, 0.75>, rgb <0.35, 0.45, 0.4> translate 0.1*y } }
sphere { <-1.4, 0.8, 0>, 0.8 pigment { checker rgb <0.9, 0.5, 0.2>, rgb <0.2, 0.2, 0.3> scale 0.3 rotate <10, 20, 30> } }
box { <0.05, 0.1, -0.45>, <0.95, 1.1, 0.45> pigment { checker rgb <0.8, 0.3, 0.4>, rgb <0.95, 0.9, 0.8> scale 0.25 translate 0.03 } }
sphere { <2, 0.6, 0.3>, 0.6 pigment { checker scale 0.4 } }
