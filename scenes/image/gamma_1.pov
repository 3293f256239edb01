// assumed_gamma 1: colours are linear light.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0.6, -4> look_at <0, 0.3, 0> angle 50 }
light_source { <-3, 4, -5> rgb 1 }
background { rgb <0.2, 0.3, 0.4> }
sphere { <-0.8, 0.5, 0>, 0.6 pigment { rgb <0.8, 0.4, 0.2> } finish { phong 0.5 } }
box { <0.2, 0, -0.4>, <1.2, 1, 0.6> pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } } finish { ambient 1 diffuse 0 } }
plane { y, 0 pigment { checker rgb 0.5, rgb 0.25 } }
