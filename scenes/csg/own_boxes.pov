#version 3.7;
// Differences turned inside out, which end at the box of their first operand: a blob, a julia and a height field keep their own, larger than that of
// the clip in their statement.
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, 0.2, 0> angle 45 right x*4/3 }
light_source { <-4, 8, -7>, 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -1 pigment { checker rgb 0.8 rgb 0.4 } }
#declare Clip = sphere { <0.1, -0.1, 0>, 0.35 }
difference {
  blob { threshold 0.5 sphere { 0, 1.3, 1 } clipped_by { Clip } }
  sphere { <0.2, 0.1, 0.2>, 0.75 pigment { rgb <1, 0.6, 0.2> } }
  pigment { rgb <0.9, 0.2, 0.2> }
  inverse
  translate -1.5*x
}
difference {
  julia_fractal { <-0.08, 0.1, -0.5, -0.03> precision 30 clipped_by { Clip } }
  sphere { <0.2, 0.1, 0.2>, 0.75 pigment { rgb <0.5, 0.9, 0.3> } }
  pigment { rgb <0.2, 0.5, 0.9> }
  inverse
}
difference {
  height_field { function 20, 20 { x*y } translate <-0.5, -0.4, -0.5> clipped_by { Clip } }
  sphere { <0.1, 0.1, 0.1>, 0.6 pigment { rgb <0.7, 0.5, 0.9> } }
  pigment { rgb <0.2, 0.9, 0.7> }
  inverse
  translate 1.5*x
}
