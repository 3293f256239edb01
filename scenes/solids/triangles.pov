// Flat and smooth triangles.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0.5, -4> look_at <0, 0.5, 0> angle 50 }
light_source { <-2, 4, -6> rgb 1 }
background { rgb <0.2, 0.25, 0.25> }

triangle { <-1.6, -0.3, 0>, <-0.2, -0.3, 0.4>, <-0.9, 1.4, 0.2> pigment { rgb <0.9, 0.5, 0.3> } }
smooth_triangle {
  <0.2, -0.3, 0>, <-1, -0.6, -1.2>
  <1.6, -0.3, 0>, <1, -0.6, -1.2>
  <0.9, 1.4, 0>, <0, 1, -1>
  pigment { rgb <0.4, 0.6, 0.9> }
  finish { phong 0.6 }
}
triangle { <-3, -0.5, 2>, <3, -0.5, 2>, <0, 2.4, 4> pigment { rgb <0.5, 0.6, 0.4> } }
