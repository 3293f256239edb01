// Antialiasing by method 1: edges, thin bars and a highlight.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.6, -5> look_at <0, 0.6, 0> angle 48 }
light_source { <-3, 6, -4> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
sphere { <-1, 0.6, 0>, 0.6 pigment { rgb <0.8, 0.3, 0.2> } finish { specular 0.9 roughness 0.005 } }
#for (I, 0, 8)
  cylinder { <0.1 + I*0.2, 0, 0.2*I>, <0.3 + I*0.2, 1.5, 0.2*I>, 0.03 pigment { rgb <0.9, 0.85, 0.6> } }
#end
plane { y, 0 pigment { checker rgb 0.8, rgb 0.3 scale 0.4 } }
