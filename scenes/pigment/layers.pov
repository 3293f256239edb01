// Layered textures: a net over stripes over a base, each layer with its own finish.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.6, -5> look_at <0, 0.6, 0> angle 48 }
light_source { <-3, 5, -6> rgb 1 }

#declare Lines = color_map { [0.9 rgbt 1] [0.9 rgb <0.2, 0.15, 0.1>] }
#declare Layers =
  texture { pigment { gradient y color_map { [0 rgb <0.9, 0.7, 0.4>] [1 rgb <0.7, 0.3, 0.3>] } } finish { diffuse 0.7 } }
  texture { pigment { gradient x color_map { [0.5 rgbt <0.2, 0.5, 0.8, 0.5>] [0.5 rgbf <1, 1, 0.9, 0.9>] } scale 0.5 } finish { phong 0.6 } }
  texture { pigment { gradient z color_map { Lines } scale 0.2 } }
sphere { <-1, 0.8, 0>, 0.8 texture { Layers } }
box { <0.2, 0, -0.5>, <1.6, 1.2, 0.5>
  texture { Layers }
  texture { pigment { gradient x color_map { Lines } scale 0.3 } }
}
plane { y, 0 texture { pigment { rgb 0.7 } } texture { pigment { checker rgbt <0, 0, 0, 0.5>, rgbt 1 } } }
