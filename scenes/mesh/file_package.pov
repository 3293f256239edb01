// A 3MF file: centimetres, an object of two others, base materials, and colours at the corners of two faces.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <-3, 3, -4> look_at <0.4, 0.7, 0.8> angle 40 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.2, 0.22, 0.2> }

#ifdef (Whittle)
  mesh { file "wedges.3mf" }
#else
  #macro Color(C) texture { pigment { srgb C } } #end
  #macro Wedge(Own, A, B, C)
    mesh2 {
      vertex_vectors { 6, <0, 0, 0>, <2, 0, 0>, <2, 0, 1>, <0, 0, 1>, <0, 1, 0>, <0, 1, 1> }
      texture_list { 4, Color(Own) Color(A) Color(B) Color(C) }
      face_indices { 8, <0, 3, 2>, 0, <0, 2, 1>, 0, <0, 1, 4>, 0, <1, 2, 5>, 0, <1, 5, 4>, 0, <2, 3, 5>, 0,
        <3, 0, 4>, 1, 2, 3, <3, 4, 5>, 1, 3, 2 }
    }
  #end
  #declare Clay = <0.8, 128/255, 64/255>;
  #declare Slate = <64/255, 128/255, 0.8>;
  object { Wedge(Clay, <1, 0, 0>, <0, 1, 0>, <1, 1, 1>) translate 0.5*y }
  object { Wedge(Slate, Slate, Slate, Slate) rotate -90*y translate <-0.5, 0.5, 0.5> }
#end
