#version 3.8;
// Colours as levels of ITU-R BT.709: balls, an sRGB colour, and a picture on the wall that is decoded into the same levels.
global_settings { assumed_gamma bt709 }
camera { location <0, 0.3, -5> look_at 0 angle 45 right x*4/3 }
light_source { <-4, 6, -8>, 1 }
sphere { <-1.1, -0.2, 0>, 0.7 pigment { rgb <0.8, 0.3, 0.1> } finish { phong 0.5 reflection 0.2 } }
sphere { <0.5, -0.2, 0>, 0.7 pigment { srgb <0.2, 0.5, 0.9> } finish { specular 0.4 } }
plane { y, -0.9 pigment { checker srgb 0.8 rgb 0.05 } }
box { <-1.6, 0, 1>, <1.6, 1.5, 1.1> pigment { image_map { png "../pigment/weave.png" } } finish { ambient 0.3 } }
