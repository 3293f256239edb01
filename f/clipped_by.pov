// clipped_by leaves an open shell: the inside of the surface is seen, no cap is made.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.5, 2.6, -5> look_at <0, 0, 0> angle 42 }
light_source { <4, 6, -5> rgb 1 }
background { rgb <0.3, 0.3, 0.35> }

sphere {
  <-1.2, 0, 0>, 1
  clipped_by { plane { <-0.4, 1, -0.4>, 0.2 } }
  pigment { rgb <0.9, 0.6, 0.2> }
}
torus {
  0.75, 0.3
  clipped_by { box { <-2, -2, -0.1>, <2, 2, 2> } }
  pigment { rgb <0.3, 0.6, 0.9> }
  rotate -50*x
  translate <1.1, 0, 0>
}
