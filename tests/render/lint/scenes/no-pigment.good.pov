#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6>, 1 }
difference {
  sphere { 4*x, 1 pigment { rgb 1 } }
  box { 4*x, <6, 2, -2> }
  cutaway_textures
}
#default { pigment { rgb <1, 0.5, 0> } }
sphere { 0, 1 }
union {
  sphere { x, 1 }
  box { 0, 2 }
  pigment { rgb 0 }
}
