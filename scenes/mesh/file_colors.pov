// Colours of the corners in a PLY file: POV-Ray has the same faces in a mesh2 with a texture a corner.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <1.5, 4, -5> look_at <0, 0.8, 0> angle 36 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.2, 0.22, 0.2> }

#ifdef (Whittle)
  mesh { file "pyramid.ply" finish { ambient 0.1 diffuse 0.8 } }
#else
  #macro Color(C) texture { pigment { srgb C } finish { ambient 0.1 diffuse 0.8 } } #end
  mesh2 {
    vertex_vectors { 5, <-1, 0, -1>, <1, 0, -1>, <1, 0, 1>, <-1, 0, 1>, <0, 2, 0> }
    texture_list { 5, Color(<1, 0, 0>) Color(<0, 1, 0>) Color(<0, 0, 1>) Color(<1, 1, 0>) Color(<1, 1, 1>) }
    face_indices { 6, <0, 3, 2>, 0, 3, 2, <0, 2, 1>, 0, 2, 1, <0, 1, 4>, 0, 1, 4, <1, 2, 4>, 1, 2, 4,
      <2, 3, 4>, 2, 3, 4, <3, 0, 4>, 3, 0, 4 }
  }
#end
