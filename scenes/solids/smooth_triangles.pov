// Smooth triangles: the normals have to point to one side of the face; those of the second do not, and it is not drawn.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0.2, 0> angle 46 }
light_source { <-4, 6, -5>, 1 }
background { rgb <0.2, 0.3, 0.5> }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.5 } }
#macro Face(Last)
  smooth_triangle { <-0.7, -0.8, 0>, <-0.5, 0, -1>, <0.7, -0.8, 0.2>, <0.5, 0, -1>, <0, 0.9, 0.3>, Last pigment { rgb <0.9, 0.5, 0.2> } }
#end
object { Face(<0, 0.6, -1>) translate -1.8*x }
object { Face(<0, 0.6, 1>) translate -0.6*x }
object { Face(<1, 0, 0>) rotate 20*y translate 0.6*x }
object { Face(<0, -0.1, -1>) rotate 30*y scale <1, 1.4, -1> translate 1.8*x }
