#version 3.8;
// Turbulence of marble and wood moves the point and stands in the formula: a wall of two halves, and a ball with bumps of wood.
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> look_at 0 right 8*x up 6*y }
light_source { <-4, 6, -10>, 1 }

plane { z, 1
  pigment { marble turbulence 0.6 color_map { [0 rgb <0.1, 0.1, 0.3>] [0.6 rgb <0.7, 0.8, 0.8>] [1 rgb 1] } }
  clipped_by { plane { x, 0 } }
}
plane { z, 1
  pigment { wood turbulence <0.1, 0.2, 0.05> octaves 4 color_map { [0.2 rgb <0.3, 0.15, 0.05>] [0.8 rgb <0.8, 0.5, 0.2>] } scale 0.8 }
  clipped_by { plane { -x, 0 } }
}
sphere { 0, 1.4 pigment { rgb <0.8, 0.3, 0.3> } normal { wood 0.8 turbulence 0.2 scale 0.4 } finish { phong 0.4 } }
