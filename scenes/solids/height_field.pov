// Height fields: of a picture with a palette and of functions, smooth, under water, turned, seen from below, cutting and cut.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.2, 5.2, -7.5> look_at <0.1, -0.2, 0> angle 42 }
light_source { <-6, 8, -4> rgb 1 }
background { rgb <0.22, 0.24, 0.3> }

#declare Hills = height_field { png "height_field.png" translate <-0.5, 0, -0.5> scale <1.7, 1.1, 1.7> }
#declare Waves = function(x, y) { 0.4 + 0.3 * sin(9 * x) * cos(7 * y) }

object { Hills pigment { rgb <0.8, 0.6, 0.3> } translate <-2.2, 0, 1.6> }
height_field {
  function 20, 24 { Waves(x, y) }
  smooth
  translate <-0.5, 0, -0.5> scale <1.7, 0.8, 1.7>
  pigment { rgb <0.4, 0.7, 0.9> } finish { phong 0.5 }
  translate <0, 0, 1.6>
}
// Holes below the water level; the colour's brightness is the height.
height_field {
  function 40, 40 { pigment { spherical color_map { [0 rgb <0.1, 0.2, 0.4>] [1 rgb <1, 0.9, 0.2>] } translate <0.5, 0.5, 0> scale 1 } }
  water_level 0.3
  texture { pigment { rgb <0.5, 0.8, 0.4> } }
  interior_texture { pigment { rgb <0.9, 0.3, 0.3> } }
  translate <-0.5, 0, -0.5> scale <1.7, 1, 1.7> rotate <0, 30, 25> translate <2.2, 0, 1.6>
}
// The ground beneath, cut to a disc.
intersection {
  object { Hills }
  cylinder { -0.3 * y, 2 * y, 0.75 }
  pigment { rgb <0.9, 0.5, 0.6> }
  translate <-2.2, 0, -1.1>
}
// What rises above it.
difference {
  box { <-0.7, 0.1, -0.7>, <0.7, 0.95, 0.7> }
  object { Hills }
  pigment { rgb <0.6, 0.5, 0.9> }
  rotate -20*y translate <0, 0, -1.1>
}
// Clipped and inverse; and a ball clipped by the ground.
object { Hills clipped_by { sphere { <0, 0.6, 0>, 0.7 } } inverse pigment { rgb <0.8, 0.8, 0.4> } translate <2.2, 0, -1.1> }
sphere { <0, 0.45, 0>, 0.55 clipped_by { object { Hills inverse } } pigment { rgb <0.3, 0.8, 0.7> } translate <2.2, 0.05, -1.1> }
