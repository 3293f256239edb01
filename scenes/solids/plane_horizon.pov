// Planes with any normal and offset; one seen edge-on from far away.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -4> look_at <0, 0.8, 0> angle 60 }
light_source { <2, 5, -6> rgb 1 }

plane { y, 0 pigment { checker rgb <0.7, 0.7, 0.65>, rgb <0.3, 0.4, 0.35> } }
plane { <0, 0, -1>, -12 pigment { rgb <0.6, 0.7, 0.85> } }
plane { <2, 0.4, 0.3>, -5 pigment { rgb <0.8, 0.5, 0.4> } }
plane { <-3, 0.5, 0>, 4 inverse pigment { rgb <0.5, 0.5, 0.7> } translate 12*x }
sphere { <0.6, 0.6, 0>, 0.6 pigment { rgb <0.9, 0.8, 0.3> } }
