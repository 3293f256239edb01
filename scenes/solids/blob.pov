// Blobs: alone with textured components, negative strengths, turned capsules, and as operands.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.4, 4.5, -9> look_at <0, 0.2, 0> angle 46 }
light_source { <-4, 9, -8> rgb 1 }
background { rgb 0.3 }
#declare Pair = blob {
  threshold 0.5
  sphere { <-0.5, 0, 0>, 1, 1 }
  sphere { <0.6, 0.2, 0>, 0.9, 1.2 }
  sphere { <0.1, 0.4, -0.7>, 0.6, -1 }
}
// Each component its own colour, blended where they meet; one shows the blob's.
blob {
  threshold 0.5
  sphere { <-0.6, 0, 0>, 1, 1 pigment { rgb <1, 0.2, 0.1> } }
  cylinder { <0, -0.2, 0>, <0.9, 0.8, 0>, 0.6, 1 texture { pigment { checker rgb 1, rgb <0, 0.3, 1> scale 0.2 } finish { phong 0.8 } } }
  sphere { <0.5, -0.5, -0.3>, 0.6, 1 }
  pigment { rgb <0.2, 0.8, 0.2> }
  translate <-2.6, 0, 1>
}
object { Pair pigment { rgb <0.9, 0.7, 0.2> } rotate 30*y }
blob {
  threshold 0.3
  cylinder { <-0.8, 0, 0>, <0.8, 0, 0>, 0.5, 1 scale <1, 1.6, 1> rotate 20*z }
  cylinder { <0, 0, -1>, <0, 0, 1>, 0.4, -0.8 }
  sphere { <0, 0.8, 0>, 0.5, 1 scale <1.4, 0.7, 1> }
  pigment { rgb <0.4, 0.6, 0.9> }
  rotate <10, -30, 0> translate <2.6, 0, 1>
}
difference { object { Pair } box { <-2, -2, -2>, <2, 2, -0.2> } pigment { rgb <0.8, 0.4, 0.6> } scale 0.8 translate <-2.2, 0, -1.8> }
intersection { box { -0.7, 0.7 } object { Pair inverse } pigment { rgb <0.5, 0.8, 0.5> } rotate 20*y translate <0, 0, -2.2> }
object { Pair clipped_by { plane { <0.3, 1, 0>, 0.2 } } pigment { rgb <0.9, 0.5, 0.3> } interior_texture { pigment { rgb <0.2, 0.3, 0.9> } } scale 0.8 translate <2.2, 0, -1.8> }
