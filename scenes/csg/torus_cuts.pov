// A torus as first operand, as cutter, and cut open by a half-space.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -6> look_at <0, 0, 0> angle 58 }
light_source { <3, 7, -6> rgb 1 }
background { rgb <0.12, 0.1, 0.14> }

difference {
  torus { 0.75, 0.32 pigment { rgb <0.85, 0.4, 0.3> } }
  box { <-0.3, -1, -2>, <0.5, 1, 0> pigment { rgb <0.95, 0.9, 0.7> } }
  rotate -25*x
  translate -2.2*x
}
difference {
  cylinder { -0.6*y, 0.6*y, 0.95 pigment { rgb <0.6, 0.65, 0.7> } }
  torus { 0.95, 0.35 pigment { rgb <0.2, 0.5, 0.7> } }
  torus { 0.4, 0.2 translate 0.6*y pigment { rgb <0.9, 0.7, 0.2> } }
}
intersection {
  torus { 0.7, 0.35 rotate 90*x }
  plane { <0.3, 1, -0.2>, 0.15 pigment { rgb 0.9 } }
  pigment { rgb <0.4, 0.7, 0.4> }
  translate 2.2*x
}
