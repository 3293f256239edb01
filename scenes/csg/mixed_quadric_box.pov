// A quadric with mixed terms has for POV-Ray no box of its own, so that a union of it with a solid turned inside out has none either.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 0.6, -5> look_at 0 angle 40 }
light_source { <-5, 9, -8> rgb 1 shadowless }
background { rgb <0.3, 0.5, 0.8> }
intersection {
  box { -1, 1 }
  union { sphere { 0, 0.5 inverse } quadric { <1.5, 1.4, 1.4>, <0.4, -0.1, -0.2>, 0, -0.6 translate 0.3*y } split_union off }
  pigment { rgb <0.9, 0.5, 0.8> } rotate 25*y translate -0.2*y
}
