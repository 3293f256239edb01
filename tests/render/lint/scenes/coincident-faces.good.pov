#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6>, 1 }
difference {
  box { 0, 1 }
  cylinder { <0.5, 0.5, 0>, <0.5, 1.01, 0>, 0.2 }
  box { <-1, 1, -1>, <2, 2, 2> }
  sphere { <0.5, 0.5, 0.5>, 0.5 }
  cylinder { <0.5, 0.5, -1>, <0.5, 0.5, 2>, 0.5 }
  pigment { rgb 1 }
}
