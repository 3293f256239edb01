// no_image and no_reflection: seen only in the mirror, and only directly.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.5, -5> look_at <0, 0.7, 0> angle 50 }
light_source { <-3, 6, -4> rgb 1 }
background { rgb <0.5, 0.6, 0.7> }
box { <-3, 0, 2>, <3, 2.2, 2.1> pigment { rgb 0 } finish { reflection 0.9 } }
sphere { <-1, 0.6, 0>, 0.6 no_image pigment { rgb <0.9, 0.4, 0.3> } }
sphere { <1, 0.6, 0>, 0.6 no_reflection pigment { rgb <0.3, 0.6, 0.4> } }
plane { y, 0 pigment { checker rgb 0.8, rgb 0.5 } }
