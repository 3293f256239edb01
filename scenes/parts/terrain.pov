// A height field of a function, cut to a block.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { perspective location <3, 6, -8> look_at <0, 0.3, 0> angle 30 }
light_source { <-20, 40, -30>, rgb 0.9 }
light_source { <30, 10, -20>, rgb 0.35 shadowless }
background { rgb 0.85 }
#declare Paint = texture { pigment { rgb <0.5, 0.6, 0.35> } finish { ambient 0.1 diffuse 0.9 } }

// Below a height field all is inside: the box ends it.
#declare Terrain = intersection {
  height_field { function 48, 48 { 0.35 + 0.2 * sin(9 * x) * cos(7 * y) + 0.25 * exp(-14 * ((x - 0.6) * (x - 0.6) + (y - 0.45) * (y - 0.45))) } translate <-0.5, 0, -0.5> scale <4, 1.5, 4> }
  box { <-1.9, -0.3, -1.9>, <1.9, 3, 1.9> }
}
object { Terrain texture { Paint } }
