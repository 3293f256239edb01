// Faces whose corners have textures of their own, mixed in between; shiny, clear and plain ones among them.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.3, 1.2, -4.2> look_at <0, 0.1, 0> angle 48 }
light_source { <-3, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.45, 0.5, 0.6> } }

#declare Red = texture { pigment { rgb <0.9, 0.15, 0.1> } finish { ambient 0.1 diffuse 0.7 phong 0.6 } }
#declare Green = texture { pigment { rgb <0.2, 0.7, 0.2> } finish { ambient 0.1 diffuse 0.8 } }
#declare Stripes = texture { pigment { gradient x color_map { [0.5 rgb <0.1, 0.2, 0.8>][0.5 rgb 0.95] } scale 0.2 } }
#declare Clear = texture { pigment { rgbt <1, 0.9, 0.5, 0.8> } }

mesh2 {
  vertex_vectors { 5, <-1, -0.5, -1>, <1, -0.5, -1>, <1, -0.5, 1>, <-1, -0.5, 1>, <0, 1, 0> }
  texture_list { 4, texture { Red } texture { Green } texture { Stripes } texture { Clear } }
  face_indices { 6, <0, 1, 4>, 0, 1, 2, <1, 2, 4>, 1, 2, 3, <2, 3, 4>, 3, <3, 0, 4>, 2, 0, 1, <0, 2, 1>, <0, 3, 2> }
  pigment { rgb <0.8, 0.8, 0.3> }
  rotate 20*y
  translate <-1.1, 0, 0>
}
mesh {
  triangle { <-0.7, 0, 0>, <0.7, -0.6, 0.3>, <0, 1.1, 0.2> texture_list { Red Stripes Green } }
  smooth_triangle { <0.7, -0.6, 0.3>, <0.5, 0.3, -1>, <1.2, 0.3, -0.3>, <0, 1, -0.5>, <0, 1.2, 0>, <0, 0.4, 1> texture { Green } }
  triangle { <-0.7, 0, 0>, <-0.2, -0.9, -0.2>, <0.4, -0.8, -0.6> }
  texture { Red }
  scale <0.9, 1, 1>
  translate <1.2, 0, 0>
}
