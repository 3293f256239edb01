// Copies of one declaration in one another: each has an interior of its own
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 2, -6> look_at <0, 0.7, 0> angle 50 }
light_source { <-5, 8, -6> rgb 1 }
plane { y, 0 pigment { checker rgb <0.9, 0.8, 0.6> rgb <0.3, 0.4, 0.5> scale 0.5 } }
#declare Ball = sphere { 0, 0.8 pigment { rgbf <0.9, 0.95, 1, 0.85> } finish { reflection 0.08 specular 0.5 } interior { ior 1.3 } }
object { Ball translate <-1.6, 0.8, 0> }
object { Ball scale 0.6 translate <-1.6, 0.8, 0> }
#declare Pair = union { object { Ball } object { Ball translate 0.7*x } }
object { Pair scale 0.9 translate <0.3, 0.8, -0.4> }
object { Pair scale <0.5, 0.9, 0.5> rotate 60*y translate <1.6, 0.8, 1.2> }
