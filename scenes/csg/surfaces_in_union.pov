// Discs, triangles and meshes bound nothing: in a union they are only drawn.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.6, 2.4, -5> look_at <0, 0.1, 0> angle 50 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.25, 0.25, 0.3> }

union {
  disc { <0, 0, 0>, y, 1.8, 1.0 pigment { rgb <0.85, 0.8, 0.5> } }
  sphere { <0, 0, 0>, 0.8 pigment { rgb <0.7, 0.3, 0.25> } }
  triangle { <-1.6, 0, 0.8>, <-0.4, 1.8, 0.8>, <0, 0, 0.8> pigment { rgb <0.3, 0.6, 0.5> } }
  mesh {
    triangle { <0.6, 0, 0.6>, <1.8, 0, 0.6>, <1.2, 1.4, 0.6> }
    triangle { <1.2, 0, 0>, <1.2, 0, 1.2>, <1.2, 1.4, 0.6> }
    pigment { rgb <0.4, 0.5, 0.9> }
  }
  rotate -15*y
}
