// no_bump_scale: aoi asks for the angle, however long the normal; what a normal_map or a list makes of its neighbours is normalised, an
// average is not. slope shows what is left of the length.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0, -9> look_at 0 angle 38 }
light_source { <-5, 9, -8> rgb 1 }
background { rgb <0.2, 0.24, 0.3> }

#declare Rough = normal { bumps 0.5 scale 0.3 }
#declare Holes = normal { dents 1 scale 0.2 }
#declare List = normal { checker normal { Rough no_bump_scale } normal { Holes } scale 0.4 no_bump_scale }
#declare Map = normal { gradient x normal_map { [0 List] [1 bumps 0.3] } }
#declare UnscaledMap = normal { gradient x normal_map { [0 Rough] [1 bumps 0.3] } scale 0.7 no_bump_scale }
#declare Mean = normal { average normal_map { [1 List] [1 bumps 0.3] } scale 0.7 no_bump_scale }
#declare Slope = pigment { slope x color_map { [0 rgb <0.9, 0.1, 0>] [1 rgb <0, 0.6, 1>] } }
#declare Angle = pigment { aoi color_map { [0.5 rgb <0.1, 0.2, 0.6>] [1 rgb <1, 0.9, 0.5>] } }

#macro Ball(Column, Row)
  sphere { <Column * 1.3 - 1.95, 0.65 - Row * 1.3, 0>, 0.6
#end
Ball(0, 0) pigment { Angle } normal { Rough no_bump_scale } }
Ball(1, 0) pigment { Angle } normal { UnscaledMap } }
Ball(2, 0) pigment { Angle } normal { Mean } }
Ball(3, 0) pigment { rgb 0.9 } normal { aoi 1 scale 0.3 no_bump_scale } finish { specular 0.5 } }
Ball(0, 1) pigment { Slope } normal { Map } finish { specular 0.5 } }
Ball(1, 1) pigment { Slope } normal { UnscaledMap } }
Ball(2, 1) pigment { Slope } normal { Mean } }
Ball(3, 1) pigment { rgb 0.9 } normal { UnscaledMap } finish { reflection 0.5 specular 0.5 } }
