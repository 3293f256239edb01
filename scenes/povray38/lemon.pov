#version 3.8;
// Arcs turned about their chords: pointed, between discs, without them, as a part of a ball, and in CSG.
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at <0, 0.1, 0> angle 48 }
light_source { <4, 8, -6>, rgb 1 }
light_source { <-5, 2, -4>, rgb 0.4 shadowless }
#declare Look = finish { ambient 0.1 diffuse 0.7 specular 0.4 roughness 0.02 }
plane { y, -1.2 pigment { checker rgb 0.8, rgb 0.5 } finish { ambient 0.1 diffuse 0.7 } }
lemon { <-2.4, -1, 0>, 0, <-2.4, 1.2, 0>, 0, 1.6 pigment { rgb <0.9, 0.8, 0.2> } finish { Look } }
lemon { <-0.9, -1, 0>, 0.5, <-0.9, 1, 0.6>, 0.15, 1.9 pigment { rgb <0.3, 0.6, 0.9> } finish { Look } }
lemon { <0.6, -1, 0>, 0.4, <0.6, 0.8, 0>, 0.4, 1.3 open
  pigment { rgb <0.9, 0.4, 0.3> } interior_texture { pigment { rgb <0.3, 0.8, 0.4> } finish { Look } } finish { Look } rotate -12*z }
difference {
  lemon { <2.2, -1, 0>, 0.3, <2.2, 0.9, 0>, 0.2, 1.2 }
  lemon { <2.2, 0.1, -2>, 0, <2.2, 0.1, 2>, 0, 4 scale <1, 1, 1> }
  pigment { rgb <0.7, 0.5, 0.9> } finish { Look }
}
lemon { <-1.6, -1.2, -1.8>, 0.45, <-1.6, -0.7, -1.8>, 0.3, 0.56 pigment { rgb 0.9 } finish { Look } }
lemon { <0, -1.2, -2>, 0.2, <1.4, -1.1, -1.6>, 0.05, 40 sturm pigment { rgb <0.2, 0.7, 0.7> } finish { Look } }
