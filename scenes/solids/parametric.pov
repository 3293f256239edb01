// Surfaces of two parameters: in a sphere and in a box, precomputed or not, with u and v as texture, in a union.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.2, 0> angle 46 }
light_source { <-6, 9, -10> rgb 1 }
background { rgb 0.3 }
plane { y, -1.8 pigment { checker rgb 0.5, rgb 0.7 } }
parametric {
  function { sin(u)*cos(v) }, function { sin(u)*sin(v) }, function { cos(u) }
  <0, 0>, <2*pi, pi>
  contained_by { sphere { 0, 1.1 } }
  max_gradient 1.5
  precompute 8 x, y, z
  uv_mapping
  pigment { checker rgb <0.9, 0.4, 0.2>, rgb <0.2, 0.4, 0.9> scale 0.5 }
  rotate <30, 20, 0>
  translate <-2.3, 0.8, 0>
}
parametric {
  function { u }, function { 0.3*sin(4*u)*v }, function { v }
  <-1, -1>, <1, 1>
  contained_by { box { <-1.01, -0.4, -1.01>, <1.01, 0.4, 1.01> } }
  max_gradient 1.3
  accuracy 0.002
  pigment { rgb <0.3, 0.8, 0.4> }
  rotate <-40, 25, 0>
  scale <1.3, 1, 1.2>
  translate <0.7, 0.8, 0.5>
}
union {
  parametric {
    function { (0.7 + 0.25*cos(v))*cos(u) }, function { 0.25*sin(v) + 0.1*u }, function { (0.7 + 0.25*cos(v))*sin(u) }
    <0, 0>, <4*pi, 2*pi>
    contained_by { box { <-1, -0.3, -1>, <1, 1.6, 1> } }
    max_gradient 1
    accuracy 0.003
    precompute 10 x, y, z
  }
  sphere { <0, -0.2, 0>, 0.4 }
  pigment { rgb <0.8, 0.7, 0.3> }
  rotate -20*x
  translate <2.7, -0.6, -1.2>
}
parametric {
  function { u*u }, function { u + v }, function { v*v }
  <-1, -1>, <1, 1>
  contained_by { box { -1.2, 1.2 } }
  max_gradient 2
  clipped_by { plane { y, 0.4 } }
  pigment { rgb <0.8, 0.3, 0.6> }
  translate <-1.4, -0.7, -1.5>
}
