// Faces in one place: of boxes beside, within and over each other, of three planes, of a union and of a glass box on the
// floor. Which of them is seen is told by the order in which POV-Ray asks.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.7, 4.2, -9> look_at <0, -0.4, 0> angle 46 }
light_source { <20, 30, -40> rgb 1 }
#macro Coloured(Red, Green, Blue) pigment { rgb <Red, Green, Blue> } #end
plane { y, -3 Coloured(0.4, 0.9, 0.3) }
box { <-3, -3, -1>, <0, -1, 2> Coloured(0.8, 0.3, 0.2) }
box { <-2, -3, -1>, <1, -2, 1> Coloured(0.2, 0.4, 0.8) }
plane { y, -3 Coloured(0.4, 0.2, 0.6) }
box { <-3, -2, -1>, <-1, 0, 1> Coloured(0.9, 0.8, 0.2) }
union {
  box { <0, -3, 0>, <3, -1, 3> Coloured(0.2, 0.7, 0.7) }
  box { <1, -2, 0>, <4, 0, 2> Coloured(0.8, 0.4, 0.8) }
  box { <2, -3, 0>, <3, 1, 1> Coloured(0.9, 0.9, 0.9) }
}
box { <0, -1, -1>, <2, 1, 2> Coloured(0.9, 0.5, 0.1) }
box { <-1, -1, -1>, <1, 0, 0> Coloured(0.3, 0.6, 0.2) }
box { <1, -3, -4>, <3, -2, -2> pigment { rgbf <0.9, 1, 0.95, 0.9> } interior { ior 1.3 } }
box { <-3, -3, -3>, <-2, -2, -1> Coloured(0.1, 0.2, 0.5) }
box { <-4, -3, -3>, <-1, -2, -2> Coloured(0.7, 0.7, 0.4) }
plane { y, -3 Coloured(0.75, 0.7, 0.6) }
sphere { <-2, 1, 0>, 1 Coloured(0.6, 0.1, 0.3) finish { reflection 0.4 } }
