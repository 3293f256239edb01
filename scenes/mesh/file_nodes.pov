// A GLB file: nodes that turn and move, a picture within the file, smooth normals, a colour; z is turned round.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <-1, 2, -6> look_at <-0.4, 1, 0> angle 40 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.2, 0.22, 0.2> }

#ifdef (Whittle)
  mesh { file "tiles.glb" }
#else
  mesh {
    triangle { <-0.5, 0, 0>, <1.5, 0, 0>, <1.5, 2, 0> uv_vectors <0, 0>, <1, 0>, <1, 1> }
    triangle { <-0.5, 0, 0>, <1.5, 2, 0>, <-0.5, 2, 0> uv_vectors <0, 0>, <1, 1>, <0, 1> }
    texture { pigment { uv_mapping image_map { png "tiles.png" gamma srgb interpolate 2 } } }
  }
  #declare A = <1, 1, -1>;
  #declare B = <-1, -1, -1>;
  #declare C = <-1, 1, 1>;
  #declare D = <1, -1, 1>;
  mesh {
    #macro Face(A, B, C) smooth_triangle { 0.7*A, A, 0.7*B, B, 0.7*C, C } #end
    Face(A, C, B) Face(A, B, D) Face(A, D, C) Face(B, C, D)
    pigment { rgb <0.8, 0.3, 0.1> }
    finish { emission <0, 0, 0.1> }
    matrix <1, 0, 0, 0, 1.2, 0, 0, 0, 1, 0, 0, 0>
    rotate -90*y
    translate <-1.7, 1, 0.5>
  }
#end
