// Transformations act in the order in which they are written.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 4, -7> look_at <0, 0, 0> angle 52 }
light_source { <-3, 8, -6> rgb 1 }

#declare Brick = box { <-0.6, 0, -0.25>, <0.6, 0.3, 0.25> }
object { Brick pigment { rgb <0.8, 0.3, 0.3> } translate 2*x rotate 40*y }
object { Brick pigment { rgb <0.3, 0.8, 0.3> } rotate 40*y translate 2*x }
object { Brick pigment { rgb <0.3, 0.4, 0.9> } scale <1, 3, 1> rotate 30*z translate -2*x }
object { Brick pigment { rgb <0.9, 0.8, 0.3> } rotate 30*z scale <1, 3, 1> translate -2*x rotate -50*y }
object { Brick pigment { rgb <0.7, 0.4, 0.8> } rotate <30, 60, 90> translate <0, 0.2, -1> }
plane { y, -0.7 pigment { rgb 0.7 } }
