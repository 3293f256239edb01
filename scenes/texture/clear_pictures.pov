// Pictures that let light through: a GIF's transparent colour, alpha, colours already multiplied by it;
// and where a picture is not, its layer still shines.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 8*x up 6*y direction z }
light_source { <-20, 30, -40> rgb 1 }
plane { -z, -1 pigment { checker rgb 1, rgb <0.2, 0.3, 0.5> scale 0.25 } finish { ambient 0.4 diffuse 0.6 } }
#declare Bright = finish { ambient 0.9 diffuse 0.1 }
#macro Place(C, R) scale <1.8, 1.8, 1> translate <C*2 - 3.9, R*2 - 2.9, 0> #end
#declare Sheet = box { <0, 0, 0>, <1, 1, 0.05> no_shadow }

object { Sheet pigment { image_map { gif "shapes.gif" } } finish { Bright } Place(0, 2) }
object { Sheet pigment { image_map { gif "shapes.gif" interpolate 2 } } finish { Bright } Place(1, 2) }
object { Sheet pigment { image_map { gif "shapes.gif" transmit 1 0.7 filter 2 0.5 } } finish { Bright } Place(2, 2) }
object { Sheet pigment { image_map { gif "shapes.gif" once } scale 0.6 } finish { Bright phong 0.6 phong_size 2 } Place(3, 2) }
object { Sheet pigment { image_map { png "glow.png" } } finish { Bright } Place(0, 1) }
object { Sheet pigment { image_map { png "glow.png" premultiplied on } } finish { Bright } Place(1, 1) }
object { Sheet pigment { image_map { png "glow.png" premultiplied on interpolate 2 } } finish { Bright } Place(2, 1) }
object { Sheet pigment { image_map { png "glow.png" premultiplied off transmit all 0.2 } } finish { Bright } Place(3, 1) }
object { Sheet texture { pigment { rgb <0.9, 0.8, 0.2> } finish { Bright } } texture { pigment { image_map { gif "shapes.gif" } } finish { Bright } } Place(0, 0) }
object { Sheet texture { material_map { gif "shapes.gif" texture { pigment { rgb <1, 0, 0> } } texture { pigment { rgb <0, 1, 0> } finish { Bright } } texture { pigment { checker scale 0.1 } } } } Place(1, 0) }
object { Sheet pigment { image_pattern { png "glow.png" use_alpha } color_map { [0 rgb <1, 0, 0>] [1 rgb <0, 0, 1>] } } finish { Bright } Place(2, 0) }
object { Sheet pigment { image_pattern { png "glow.png" premultiplied on } color_map { [0 rgb 0] [1 rgb 1] } } finish { Bright } Place(3, 0) }
