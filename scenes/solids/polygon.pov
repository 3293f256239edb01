// Polygons: alone, with holes, moved, two-faced, cutting, cut and clipped.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.3, 0.4, -9> look_at <0, 0, 0> angle 42 }
light_source { <-5, 8, -10> rgb 1 }
background { rgb <0.22, 0.24, 0.3> }

#declare Star = polygon { 6, <0, 1, 0>, <0.59, -0.81, 0>, <-0.95, 0.31, 0>, <0.95, 0.31, 0>, <-0.59, -0.81, 0>, <0, 1, 0> }
#declare Frame = polygon {
  15,
  <-1, -1, 0>, <1, -1, 0>, <1, 1, 0>, <-1, 1, 0>, <-1, -1, 0>
  <-0.7, -0.7, 0>, <-0.1, -0.7, 0>, <-0.1, 0.7, 0>, <-0.7, 0.7, 0>, <-0.7, -0.7, 0>
  <0.2, 0.1, 0>, <0.8, 0.1, 0>, <0.8, 0.8, 0>, <0.5, 0.3, 0>, <0.2, 0.1, 0>
}

// Crossing edges: even-odd.
object { Star pigment { rgb <0.9, 0.7, 0.2> } translate <-2.3, 1.2, 0> }
// Loops inside a loop.
object { Frame pigment { rgb <0.4, 0.7, 0.9> } rotate <0, 30, 0> scale 0.9 translate <0, 1.25, 0> }
// Seen from behind: another texture.
object {
  Star
  texture { pigment { rgb <0.8, 0.2, 0.2> } }
  interior_texture { pigment { checker rgb 0.2 rgb 0.9 scale 0.2 } }
  rotate <15, 160, 20> scale <1.3, 0.9, 1> translate <2.3, 1.25, 0>
}
// Cut: the half inside the cut is gone.
difference {
  object { Frame }
  cylinder { <0.3, 0.2, -1>, <0.3, 0.2, 1>, 0.6 }
  pigment { rgb <0.5, 0.85, 0.4> }
  rotate -25*y scale 0.9 translate <-2.3, -1.25, 0>
}
// Within a solid: seen where the solid is.
intersection {
  sphere { 0, 0.9 }
  polygon { 4, <-2, -0.5, 0.1>, <2, -0.5, 0.1>, <0, 1.5, -0.2>, <-2, -0.5, 0.1> }
  pigment { rgb <0.9, 0.5, 0.7> }
  translate <0, -1.25, 0>
}
// Clipped.
object { Frame clipped_by { sphere { <0.2, 0.2, 0>, 1 } } pigment { rgb <0.9, 0.6, 0.4> } inverse rotate 35*x scale 0.9 translate <2.3, -1.25, 0> }
