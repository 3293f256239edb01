// background shows behind everything and in mirrors.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { color rgb <0.8, 0.45, 0.2> }
camera { location <0, 0, -4> look_at 0 angle 44 }
light_source { <-3, 5, -5> rgb 1 }
sphere { <-0.8, 0, 0>, 0.7 pigment { rgb <0.2, 0.4, 0.6> } }
sphere { <0.8, 0, 0>, 0.7 pigment { rgb 0 } finish { reflection 0.8 } }
