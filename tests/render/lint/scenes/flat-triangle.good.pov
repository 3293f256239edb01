#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6>, 1 }
mesh2 {
  vertex_vectors { 4, 0, x, x + y, y }
  face_indices { 2, <0, 1, 3>, <1, 2, 3> }
  pigment { rgb 1 }
}
