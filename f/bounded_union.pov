// Bounds of unions and of operands that do not hold what they bound. The light makes no shadows: those of what sticks out depend
// in POV-Ray on which pixel was shaded before.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -11> look_at <0, 0, 0> angle 46 }
light_source { <-5, 8, -10> rgb 1 shadowless }
background { rgb <0.22, 0.24, 0.3> }

#declare Pair = union { sphere { 0, 0.9 } box { <0.9, -0.9, -0.9>, <2.7, 0, 0.9> } bounded_by { sphere { 0, 1.1 } } }
// Alone, in a difference, in an intersection whose box is smaller for it, clipped.
object { Pair pigment { rgb <0.4, 0.7, 0.9> } rotate <10, 30, 15> translate <-3.4, 2, 0> }
difference { object { Pair } sphere { -0.6*z, 0.6 } pigment { rgb <0.9, 0.5, 0.5> } rotate 10*x translate <-0.4, 2, 0> }
intersection { object { Pair } plane { z, 0.4 } pigment { rgb <0.5, 0.85, 0.4> } translate <2.6, 2, 0> }
union { object { Pair } sphere { -1.1*x, 0.5 } clipped_by { plane { y, 0.3 } } pigment { rgb <0.9, 0.8, 0.4> } translate <-3, -0.2, 0> }
// Bounds of operands of kinds that lose theirs when they stand alone.
union {
  sphere { 0, 0.9 bounded_by { sphere { 0.45*y, 0.7 } } }
  torus { 1, 0.35 bounded_by { sphere { <0.8, 0, -0.8>, 0.7 } } }
  bounded_by { sphere { 0, 1.8 } }
  pigment { rgb <0.7, 0.5, 0.9> } translate <0, -0.4, 0>
}
torus { 0.9, 0.35 bounded_by { box { <0, -1, -1>, <2, 1, 1> } } pigment { rgb <0.4, 0.8, 0.8> } rotate -40*x translate <2.8, -0.2, 0> }
// Two bounds, one without end; the corners of a box.
union { sphere { 0, 0.9 } box { <0.9, -0.9, -0.9>, <2.7, 0, 0.9> } bounded_by { sphere { 0, 1.1 } plane { y, 0.3 } } pigment { rgb <0.9, 0.6, 0.3> } translate <-3, -2.6, 0> }
union { box { -0.9, 0.9 bounded_by { sphere { 0, 1.1 } } } rotate 25*y pigment { rgb <0.6, 0.7, 0.5> } translate <0.4, -2.6, 0> }
merge { object { Pair } sphere { -0.9*x, 0.4 } pigment { rgb <0.8, 0.8, 0.8> } translate <3, -2.6, 0> }
