// Index of refraction in the finish of a group: its interior, which operands with textures of their own share
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 2.5, -9> look_at <0, 0, 0> angle 50 }
background { rgb <0.55, 0.7, 0.85> }
light_source { <-8, 12, -9> rgb 1 }
plane { y, -1.2 pigment { checker rgb 1 rgb 0.25 scale 0.6 } }
#declare Pane = box { -0.6, 0.6 rotate <20, 30, 10> pigment { rgbf <0.9, 0.6, 0.9, 0.8> } }
#declare Ball = sphere { <0.2, 0.5, -0.3>, 0.5 pigment { rgbf <0.6, 0.9, 0.8, 0.8> } }
#declare Group = union { object { Pane } object { Ball } texture { pigment { rgb 1 } finish { ior 1.35 } } }
union { object { Pane } object { Ball } finish { ior 1.5 } translate -2.8*x }
difference { object { Pane } object { Ball } finish { ior 1.3 } translate -0.9*x }
object { Group translate 1*x }
object { Group finish { ior 1.6 } scale 0.8 translate 2.8*x }
union { object { Pane interior { ior 1.1 } } object { Ball finish { ior 1.8 } } finish { ior 1.4 } scale 0.6 translate <0, 1.6, 0> }
