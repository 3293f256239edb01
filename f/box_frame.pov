// A box with a window through each pair of sides, and the same frame turned inside it.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <2.4, 2, -3.6> look_at <0, -0.1, 0> angle 38 }
light_source { <1, 6, -5> rgb 1 }
background { rgb <0.3, 0.4, 0.5> }

#declare Frame = difference {
  box { -1, 1 }
  box { <-0.8, -0.8, -1.1>, <0.8, 0.8, 1.1> }
  box { <-0.8, -1.1, -0.8>, <0.8, 1.1, 0.8> }
  box { <-1.1, -0.8, -0.8>, <1.1, 0.8, 0.8> }
}
object { Frame pigment { rgb <0.9, 0.7, 0.3> } }
object { Frame pigment { rgb <0.7, 0.25, 0.3> } scale 0.6 rotate <20, 25, 10> }
plane { y, -1.2 pigment { rgb 0.5 } }
