// Which texture a cut face has: the cutter's own, the parent's for an untextured cutter, patterns running on.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3.2, -6> look_at <0, -0.1, 0> angle 62 }
light_source { <-3, 7, -6> rgb 1 }
background { rgb <0.1, 0.1, 0.15> }

#declare Stripes = pigment {
  gradient x color_map { [0.5 rgb <0.9, 0.85, 0.6>] [0.5 rgb <0.45, 0.25, 0.15>] } scale 0.3
}
// cutter with its own texture
difference {
  sphere { 0, 1 pigment { Stripes } }
  box { <0, 0, -2>, <2, 2, 2> pigment { rgb <0.2, 0.7, 0.9> } }
  translate -2.3*x
}
// neither child has one: the parent's pattern covers the cut as well
difference {
  sphere { 0, 1 }
  box { <0, 0, -2>, <2, 2, 2> }
  pigment { Stripes }
}
// only the cutter lacks one and takes the parent's
difference {
  sphere { 0, 1 pigment { Stripes rotate 90*z } }
  box { <0, 0, -2>, <2, 2, 2> }
  pigment { checker rgb 1, rgb <0.7, 0.1, 0.1> scale 0.2 }
  translate 2.3*x
}
