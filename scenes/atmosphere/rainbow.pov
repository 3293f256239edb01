// A rainbow over a wall, a mirror and the sky: its colours hide what is behind by their transmit and by the distance.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 3, 0> angle 90 }
light_source { <-5, 9, -9>, 1 }
background { rgb <0.25, 0.4, 0.7> }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.5, 0.2> } }
sphere { <2, 1.5, 0>, 1.5 pigment { rgb <0.8, 0.6, 0.3> } finish { reflection 0.5 } }
box { <-6, 0, 4>, <-2, 4, 5> pigment { rgb <0.9, 0.3, 0.3> } }
rainbow {
  direction <0, -0.2, 1> angle 35 width 9 distance 12
  color_map {
    [0.0 rgbt <0.6, 0.1, 0.9, 0.95>] [0.2 rgbt <0.2, 0.2, 1, 0.6>] [0.5 rgbft <0.1, 0.9, 0.2, 0.3, 0.5>]
    [0.8 rgbt <1, 0.9, 0.1, 0.5>] [1.0 rgbt <1, 0.1, 0.1, 0.98>]
  }
}
