// Copies painted anew: a pigment in the place of a plain colour is moved by all that has moved the object since it got that colour
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0, 0> angle 54 }
background { rgb <0.6, 0.7, 0.8> }
light_source { <-6, 9, -8> rgb 1 }
#declare Late = sphere { 0, 1 scale <1, 0.8, 1> rotate 30*z pigment { rgb x } }
#declare Early = sphere { 0, 1 pigment { rgb x } scale <1, 0.8, 1> rotate 30*z }
#declare Twice = object { Late scale 0.9 translate 0.2*x }
#declare Both = union { box { -0.7, 0.7 } cylinder { -y, y, 0.4 } rotate 20*y texture { pigment { rgb z } scale 2 } }
object { Late translate <-3, 1.2, 0> pigment { gradient x scale 0.4 } }
object { Early translate <-1, 1.2, 0> pigment { gradient x scale 0.4 } }
object { Twice translate <1, 1.2, 0> rotate 10*z pigment { checker scale 0.3 } finish { phong 0.6 } }
object { Both translate <3, 1.2, 0> pigment { wood scale 0.3 } }
object { Late translate <-3, -1.2, 0> texture { pigment { rgb y } } rotate 15*x pigment { gradient y scale 0.3 } }
sphere { 0, 0.9 translate <-1, -1.2, 0> pigment { rgb 1 } rotate 25*y pigment { checker scale 0.25 } translate 0.1*y }
object { Late texture { pigment { bozo } finish { ambient 0.3 } } translate <1, -1.2, 0> pigment { gradient x scale 0.4 } }
object { Both pigment { rgb 1 } translate <3, -1.2, 0> normal { bumps 0.4 scale 0.2 } pigment { checker scale 0.3 } }
