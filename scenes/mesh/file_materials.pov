// Materials of an OBJ file's library, as file has them; obj has the names of declared textures, as POV-Ray 3.8 does.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <2, 3, -6> look_at <0, 0.3, 0> angle 40 }
light_source { <-3, 6, -5> rgb 1 }
plane { y, -0.5 pigment { checker rgb 0.8, rgb <0.45, 0.5, 0.6> } }

#declare P_sides = texture { pigment { srgb <0.8, 0.5, 0.2> } }
#declare P_lid = texture { pigment { srgbt <0.2, 0.5, 0.8, 0.5> } finish { emission srgb <0, 0.1, 0> } }
#ifdef (Whittle)
  mesh { file "crate.obj" translate -1.3*x }
  mesh { obj "crate.obj" texture_list { "lid" texture { P_sides } prefix "P_" } translate 1.3*x }
#else
  #macro Crate(Lid)
    mesh2 {
      vertex_vectors { 8, <-1, 0, -1>, <1, 0, -1>, <1, 0, 1>, <-1, 0, 1>, <-1, 1, -1>, <1, 1, -1>, <1, 1, 1>, <-1, 1, 1> }
      texture_list { 2, texture { P_sides } texture { Lid } }
      face_indices { 12, <0, 1, 2>, 0, <0, 2, 3>, 0, <0, 4, 5>, 0, <0, 5, 1>, 0, <1, 5, 6>, 0, <1, 6, 2>, 0,
        <2, 6, 7>, 0, <2, 7, 3>, 0, <3, 7, 4>, 0, <3, 4, 0>, 0, <4, 7, 6>, 1, <4, 6, 5>, 1 }
    }
  #end
  object { Crate(P_lid) translate -1.3*x }
  object { Crate(P_sides) translate 1.3*x }
#end
