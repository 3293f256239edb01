// A sphere, a box and a small sphere far away on the ground plane.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.2, -5> look_at <0, 0.4, 0> angle 50 }
light_source { <-4, 6, -5> rgb 1 }
background { rgb <0.5, 0.65, 0.85> }

sphere { <-0.9, 0.8, 0>, 0.8 pigment { rgb <0.8, 0.3, 0.3> } }
box { <0.2, 0, -0.4>, <1.4, 1.1, 0.8> pigment { rgb <0.85, 0.75, 0.35> } rotate -10*y }
sphere { <4, 2, 20>, 2 pigment { rgb <0.3, 0.5, 0.3> } }
plane { y, 0 pigment { rgb <0.6, 0.6, 0.55> } }
