#version 3.8;
// Eight bands from orange to blue: each blend_mode as a map of colours above and as one of pigments below, then modes 2 and 3
// with a gamma below 1. Behind them a wall whose grain is blended by its brightness.
global_settings { assumed_gamma srgb }
camera { orthographic location <0, 0, -5> look_at 0 right 4*x up 3*y }
#default { finish { ambient 0 emission 1 diffuse 0 } }

#macro Band(Row, Mode, Gamma)
  box { <-1.8, 1.2 - 0.45*Row, 0>, <0, 1.4 - 0.45*Row, 1>
    pigment { gradient x color_map { blend_mode Mode blend_gamma Gamma [0 rgb <1, 0.4, 0>] [0.6 rgbf <0, 0.3, 0.9, 0.2>] [1 rgb 1] } scale 1.8 translate -1.8*x }
  }
  box { <-1.8, 1 - 0.45*Row, 0>, <0, 1.2 - 0.45*Row, 1>
    pigment { gradient x pigment_map { blend_gamma Gamma blend_mode Mode [0 rgb <1, 0.4, 0>] [0.6 checker rgb 0.1 rgb <0, 0.3, 0.9> scale 0.1] [1 rgb 1] } scale 1.8 translate -1.8*x }
  }
#end
Band(0, 0, 2.5)
Band(1, 1, 2.5)
Band(2, 2, 2.5)
Band(3, 3, 2.5)
Band(4, 2, 0.6)
Band(5, 3, 0.6)
#declare Grain = color_map { blend_mode 3 [0 rgb <0.1, 0, 0.3>] [0.4 rgb <0.9, 0.2, 0.1>] [1 rgb <1, 1, 0.6>] }
plane { z, 2 pigment { agate color_map { Grain } scale 0.6 } }
