// Slices of Julia sets: quaternions and hypercomplex functions, alone, cut, cutting, clipped, inverse.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 4, -11> look_at <0, 0.2, 0> angle 46 }
light_source { <-6, 9, -10> rgb 1 }
background { rgb 0.3 }
plane { y, -2 pigment { checker rgb 0.5, rgb 0.7 } }
julia_fractal {
  <-0.08, 0, -0.83, -0.03>
  quaternion sqr
  max_iteration 8
  precision 30
  pigment { rgb <0.8, 0.5, 0.2> }
  rotate <20, 35, 10>
  scale 1.2
  translate <-3, 1.2, 1>
}
difference {
  julia_fractal { <-0.2, 0.5, 0.3, 0.1> quaternion cube max_iteration 7 precision 30 slice <0.2, 0.1, -0.3, 1>, 0.1 }
  box { <0, -2, -2>, <2, 2, 0> }
  pigment { rgb <0.3, 0.6, 0.8> }
}
julia_fractal {
  <0.3, 0.2, -0.4, 0.1>
  hypercomplex sqr
  max_iteration 7
  precision 40
  clipped_by { plane { x, 0.2 } }
  pigment { rgb <0.8, 0.3, 0.5> }
  rotate 30*y
  translate <2.8, 1, 1>
}
intersection {
  julia_fractal { <-0.162, 0.163, 0.56, -0.599> quaternion sqr max_iteration 9 precision 30 inverse }
  sphere { 0, 1 }
  pigment { rgb <0.5, 0.8, 0.3> }
}
julia_fractal {
  <0.3, 0.2, -0.4, 0.1>
  hypercomplex pwr(2, 0.3)
  max_iteration 6
  precision 40
  pigment { rgb <0.7, 0.7, 0.8> }
  scale 0.8
  translate <2.4, -1.2, -2.5>
}
