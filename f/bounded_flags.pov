// Parts of unions that hide: those of a bounded union, which stays one object, do not
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at <0, 0.6, 0> angle 45 }
light_source { <-4, 8, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.6 } }
#declare Parts = union {
  sphere { <-0.5, 0.6, 0>, 0.6 pigment { rgb <0.9, 0.3, 0.2> } no_shadow }
  box { <0.1, 0, -0.4>, <0.9, 0.8, 0.4> pigment { rgb <0.2, 0.5, 0.9> } no_image }
  cylinder { <0, 0, 0.9>, <0, 1.6, 0.9>, 0.2 pigment { rgb <0.3, 0.8, 0.4> } }
}
object { Parts translate -1.6*x }
object { Parts bounded_by { sphere { <0, 0.7, 0.2>, 2 } } translate 1.6*x }
