// Difference: a sphere takes a bite out of a box; the bite shows the sphere's texture.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <2.4, 2.2, -3.4> look_at <0, -0.1, 0> angle 42 }
light_source { <4, 7, -5> rgb 1 }
background { rgb <0.12, 0.16, 0.22> }

difference {
  box { -1, 1 pigment { rgb <0.85, 0.55, 0.2> } }
  sphere { <1, 1, -1>, 1.25 pigment { rgb <0.2, 0.55, 0.8> } }
  finish { diffuse 0.8 phong 0.4 }
}
