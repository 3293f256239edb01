// Quadrics made finite: a paraboloid, a hyperboloid and a double cone cut by boxes and planes.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.4, -6.5> look_at <0, 0, 0> angle 58 }
light_source { <-4, 7, -6> rgb 1 }
background { rgb <0.14, 0.14, 0.18> }

intersection {
  quadric { <1, 0, 1>, <0, 0, 0>, <0, -0.6, 0>, 0 }
  box { <-2, -1, -2>, <2, 1.7, 2> pigment { rgb <0.9, 0.8, 0.3> } }
  pigment { rgb <0.3, 0.6, 0.4> }
  rotate -20*x
  translate <-2.1, -0.8, 0>
}
intersection {
  quadric { <1, -0.8, 1>, <0, 0, 0>, <0, 0, 0>, -0.2 }
  plane { y, 1 pigment { rgb <0.9, 0.5, 0.4> } }
  plane { -y, 1 }
  pigment { rgb <0.5, 0.5, 0.9> }
}
difference {
  sphere { 0, 1.05 pigment { rgb <0.8, 0.75, 0.7> } }
  quadric { <1, -0.5, 1>, <0, 0, 0>, <0, 0, 0>, 0 pigment { rgb <0.8, 0.2, 0.2> } }
  rotate <-30, 0, 30>
  translate 2.1*x
}
