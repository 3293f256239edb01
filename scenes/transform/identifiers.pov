// Named transformations, used on objects and textures, composed, and inverted.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -7> look_at <0, 0.3, 0> angle 46 }
light_source { <3, 7, -6> rgb 1 }
background { rgb <0.25, 0.3, 0.3> }

#declare Lean = transform { rotate 25*z scale <1, 1.4, 1> }
#declare Away = transform { Lean translate <1.8, 0, 0> }
#declare Post = box { <-0.3, 0, -0.3>, <0.3, 1.2, 0.3> pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.5>] [1 rgb <0.5, 0.2, 0.2>] } } }

object { Post translate -1.8*x }
object { Post transform Lean }
object { Post transform { Away } }
object { Post transform { Away } transform { Away inverse } translate <0, 0, 2.2> scale <1.5, 1, 1> }
plane { y, 0 pigment { checker rgb 0.8, rgb 0.5 transform { Lean inverse } } }
