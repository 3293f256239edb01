#version 3.8;
// A camera by functions that looks all around from a moving place, through uneven glass: its normal.
global_settings { assumed_gamma 1 }
camera {
  user_defined
  location { function { 0.4*x } function { 0.6 } function { -0.5 } }
  direction { function { sin(1.6*x) } function { y - 0.15 } function { cos(1.6*x) } }
  normal { bumps 0.04 scale 0.2 }
}
light_source { <-4, 6, -6>, 1 }
plane { y, 0 pigment { checker rgb 0.3 rgb 0.9 } }
sphere { <-1.5, 0.5, 2>, 0.5 pigment { rgb <0.9, 0.3, 0.3> } }
box { <0.5, 0, 1.5>, <1.2, 0.9, 2> pigment { rgb <0.3, 0.5, 0.9> } }
background { rgb <0.6, 0.8, 1> }
