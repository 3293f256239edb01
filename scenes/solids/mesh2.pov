// mesh2: shared vertices, a face with smooth normals, textures by face.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.8, 1.6, -3.4> look_at <0, 0.2, 0> angle 44 }
light_source { <-2, 5, -5> rgb 1 }
background { rgb <0.25, 0.2, 0.2> }

mesh2 {
  vertex_vectors { 5, <-1, 0, -1>, <1, 0, -1>, <1, 0, 1>, <-1, 0, 1>, <0, 1.3, 0> }
  normal_vectors { 5, <-1, 0.5, -1>, <1, 0.5, -1>, <1, 0.5, 1>, <-1, 0.5, 1>, <0, 1, 0> }
  texture_list { 2, texture { pigment { rgb <0.9, 0.4, 0.3> } } texture { pigment { rgb <0.4, 0.6, 0.9> } finish { phong 0.7 } } }
  face_indices { 4, <0, 1, 4>, 0, <1, 2, 4>, 1, <2, 3, 4>, 0, <3, 0, 4>, 1 }
  normal_indices { 4, <0, 1, 4>, <1, 2, 4>, <2, 3, 4>, <3, 0, 4> }
}
plane { y, 0 pigment { rgb 0.6 } }
