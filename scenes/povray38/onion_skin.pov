#version 3.8;
// Balls with `onion`, which jumps at their radius: the last bit of each point decides.
global_settings { assumed_gamma 1 }
camera { location <-2, 3, -4> look_at <0.2, 0.1, 0> angle 40 right x*4/3 }
light_source { <-20, 30, -50>, 1 }
#declare Skin = pigment { onion color_map { [0.9 rgb <1, 0.5, 0.1>] [0.9 rgb <0.2, 0.6, 0.1>] } }
sphere { 0, 1 pigment { Skin } }
intersection {
  sphere { 0, 1 }
  sphere { 0, 0.65 inverse }
  plane { y, 0 }
  pigment { Skin }
  rotate 30*y
  translate <1.5, 0.5, -0.5>
}
plane { y, -1 pigment { checker rgb 0.8 rgb 0.4 } }
