// Closed cylinders and cones at a slant, a cone with a tip and one with equal radii.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2, -6> look_at <0, 0.3, 0> angle 52 }
light_source { <4, 6, -5> rgb 1 }
background { rgb <0.2, 0.2, 0.3> }

cylinder { <-2.4, -0.3, 0>, <-1.2, 1, 0.5>, 0.5 pigment { rgb <0.8, 0.5, 0.3> } }
cone { <-0.4, -0.5, 0>, 0.6, <-0.2, 1.2, -0.3>, 0 pigment { rgb <0.4, 0.7, 0.6> } }
cone { <0.9, 1.1, 0>, 0.2, <1, -0.5, 0>, 0.7 pigment { rgb <0.7, 0.7, 0.3> } }
cone { <2, -0.4, 0>, 0.4, <2.3, 1, 0>, 0.4 pigment { rgb <0.6, 0.4, 0.7> } }
plane { y, -0.9 pigment { rgb 0.7 } }
