// Operands under non-uniform scaling, shear and mirror images, with their spans in the right order.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.2, -5.5> look_at 0 angle 56 }
light_source { <-4, 6, -6> rgb 1 }
background { rgb <0.2, 0.15, 0.15> }

difference {
  sphere { 0, 1 scale <1.3, 0.7, 0.9> pigment { rgb <0.8, 0.6, 0.3> } }
  cylinder { -y, y, 1 scale <0.5, 2, 0.2> rotate 30*y pigment { rgb <0.3, 0.5, 0.7> } }
  torus { 1, 0.2 scale <1.2, 1, 0.9> pigment { rgb <0.7, 0.3, 0.3> } }
  translate -1.4*x
}
intersection {
  box { -0.8, 0.8 matrix <1, 0, 0, 0.5, 1, 0, 0, 0.2, 1, 0, 0, 0> pigment { rgb <0.5, 0.7, 0.4> } }
  cone { -y, 1.3, y, 0.5 scale <-1, 1, 1.2> rotate 20*z pigment { rgb <0.85, 0.8, 0.7> } }
  translate 1.4*x
}
