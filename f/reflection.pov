// Mirrors of several strengths and one of coloured reflection.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.6, -6> look_at <0, 0.6, 0> angle 50 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.5, 0.65, 0.85> }

sphere { <-1.7, 0.7, 0>, 0.7 pigment { rgb 0.05 } finish { reflection 0.3 diffuse 0.6 } }
sphere { <0, 0.7, 0.6>, 0.7 pigment { rgb 0.05 } finish { reflection 0.9 ambient 0 } }
sphere { <1.7, 0.7, 0>, 0.7 pigment { rgb 0.05 } finish { reflection rgb <0.9, 0.6, 0.2> } }
box { <-0.4, 0, -1.3>, <0.4, 0.5, -0.9> pigment { rgb <0.8, 0.3, 0.3> } }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.3> } finish { reflection 0.15 } }
