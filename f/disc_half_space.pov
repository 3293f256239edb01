// A disc in an intersection is a half-space with a flat box: only rays through that box see the solid.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0.5, 2.4, -5> look_at <0, -0.1, 0> angle 52 }
light_source { <5, 9, -8>, 0.9 }
light_source { <-5, 3, 9>, 0.4 }
plane { y, -1.5 pigment { checker rgb 0.75, rgb 0.55 } }

#declare Ball = sphere { <0.2, 0.1, 0.1>, 0.8 pigment { rgb <0.85, 0.25, 0.15> } }

intersection {
  disc { 0, z, 1.1, 0.3 pigment { rgb <0.2, 0.7, 0.3> } }
  object { Ball }
  rotate 25*y
  translate <-1.6, 0.4, 0.5>
}
difference {
  object { Ball }
  disc { 0, z, 1.1, 0.3 inverse pigment { rgb <0.2, 0.3, 0.8> } }
  rotate -35*y
  translate <0.1, 0.5, 1>
}
intersection {
  box { <-0.6, -0.5, -0.5>, <0.5, 0.5, 0.4> }
  union { disc { 0, y, 0.4 } sphere { <0.3, 0, 0>, 0.3 } }
  pigment { rgb <0.3, 0.4, 0.9> }
  translate <1.3, -0.9, -1.2>
}
union {
  intersection {
    disc { 0, y, 1.2, 0.3 }
    sphere { 0, 0.8 }
    rotate 30*x
  }
  cylinder { -1.4*y, -0.7*y, 0.3 }
  pigment { rgb <0.8, 0.7, 0.2> }
  translate <-1.2, -0.4, -1.4>
}
