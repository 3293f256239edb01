// Before 3.7 colours go to the file undecoded and assumed_gamma defaults to none.
#version 3.1;
camera { location <0, 1.5, -5> look_at <0, 0.3, 0> angle 48 }
light_source { <-3, 5, -5> color rgb 1 }
background { color rgb <0.2, 0.3, 0.4> }

sphere { <-0.9, 0.5, 0>, 0.7 texture { pigment { color rgb <0.9, 0.5, 0.3> } finish { ambient 0.2 diffuse 0.7 phong 0.5 } } }
box { <0.2, 0, -0.5>, <1.3, 1, 0.5> texture { pigment { color red 0.3 green 0.7 blue 0.4 } } }
plane { y, 0 texture { pigment { checker color rgb 0.7, color rgb 0.4 } } }
