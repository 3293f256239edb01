#version 3.8;
// Cells that come again: a wall whose tiles of 2 by 3 cells fit together, a solid kind beside it, and bumps on a ball. All
// have the same repeat: in POV-Ray 3.8 cells of one pattern turn up in another.
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> look_at 0 right 8*x up 6*y }
light_source { <-4, 6, -10>, 1 }

plane { z, 1
  pigment { crackle repeat <2, 3, 1> scale 0.8 color_map { [0 rgb 0.1] [0.2 rgb <0.8, 0.6, 0.3>] [0.8 rgb <1, 0.9, 0.6>] } }
  clipped_by { plane { x, 0 } }
}
plane { z, 1
  pigment { crackle solid repeat <2, 3, 1> scale 0.7 color_map { [0.3 rgb <0.1, 0.3, 0.6>] [0.7 rgb <0.7, 0.9, 0.5>] } }
  clipped_by { plane { -x, 0 } }
}
sphere { 0, 1.4 pigment { rgb <0.8, 0.3, 0.3> } normal { crackle 0.6 form <1, 0, 0> metric 3 repeat <2, 3, 1> scale 0.4 } finish { phong 0.4 } }
