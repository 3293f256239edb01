// A shear and a rotation by matrix, written row by row as POV-Ray wants them.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.5, -6> look_at <0, 0.3, 0> angle 48 }
light_source { <-4, 6, -5> rgb 1 }
background { rgb <0.3, 0.3, 0.4> }

box { <-0.5, 0, -0.5>, <0.5, 1, 0.5> pigment { rgb <0.9, 0.6, 0.3> } matrix <1, 0, 0, 0.6, 1, 0.2, 0, 0, 1, -1.7, 0, 0> }
cylinder { 0, y, 0.5 pigment { rgb <0.4, 0.7, 0.5> } matrix <0.8, 0, 0.6, 0, 1.3, 0, -0.6, 0, 0.4, 0, 0, 0> }
sphere { 0.5*y, 0.5 pigment { gradient y color_map { [0.5 rgb <0.9, 0.3, 0.3>] [0.5 rgb 1] } scale 0.25 } matrix <1, 0.5, 0, 0, 1, 0, 0, 0, 1, 1.6, 0, 0> }
plane { y, 0 pigment { rgb 0.65 } }
