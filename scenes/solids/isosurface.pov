// Functions as solids: alone, cut, cutting, open, inverse, clipped, made of noise and of a pattern.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3.2, -9> look_at <0, 0.1, 0> angle 46 }
light_source { <-6, 9, -10> rgb 1 }
background { rgb 0.3 }
plane { y, -1.6 pigment { checker rgb 0.5, rgb 0.7 } }
#declare Lumps = function { pattern { bozo } }
#declare Cushion = function { pow(x, 4) + pow(y, 4) + pow(z, 4) - 0.8 }
// Turned and stretched, its walls drawn.
isosurface {
  function { sin(6*x)*0.15 + y + 0.2*cos(5*z) }
  max_gradient 2
  contained_by { box { -1, 1 } }
  pigment { rgb <0.8, 0.5, 0.2> }
  rotate <20, 35, 0>
  scale <0.8, 0.8, 0.7>
  translate <-3, 1.1, 1>
}
difference {
  isosurface { function { Cushion(x, y, z) } max_gradient 5 }
  isosurface { function { x*x + y*y - 0.2 } max_gradient 3 contained_by { box { -1.2, 1.2 } } max_trace 2 }
  pigment { rgb <0.3, 0.6, 0.8> }
  rotate <25, 40, 0>
  translate <-0.6, 0.9, 0.6>
}
intersection {
  isosurface { function { z*z - x*x*0.6 - y } threshold 0.2 max_gradient 5 contained_by { sphere { 0, 1.2 } } all_intersections }
  sphere { 0, 0.9 }
  pigment { rgb <0.8, 0.3, 0.5> }
  translate <1.9, 0.9, 0.4>
}
// Open, seen from both sides.
isosurface {
  function { sqrt(x*x + z*z) - 0.5 - 0.1*sin(8*y) }
  max_gradient 1.6
  open
  max_trace 2
  pigment { rgb <0.5, 0.8, 0.3> }
  interior_texture { pigment { rgb <0.9, 0.8, 0.2> } }
  rotate 50*x
  translate <3.6, 0.8, 0.6>
}
isosurface {
  function { sqrt(x*x + y*y + z*z) - 0.7 + 0.3*Lumps(4*x, 4*y, 4*z) }
  max_gradient 3
  accuracy 0.01
  pigment { rgb <0.7, 0.7, 0.8> }
  translate <-2.6, -0.9, -1.4>
}
// Clipped, and inverse in a cut.
isosurface {
  function { abs(x) + abs(y) + abs(z) - 0.9 }
  max_gradient 2
  clipped_by { plane { <0.4, 1, -0.6>, 0.1 } }
  pigment { rgb <0.9, 0.6, 0.6> }
  translate <-0.5, -0.8, -2>
}
intersection {
  isosurface { function { x*x + y*y + z*z - 0.5 } max_gradient 4 inverse }
  box { -0.6, 0.6 }
  pigment { rgb <0.4, 0.5, 0.9> }
  rotate <10, 25, 0>
  translate <1.5, -0.9, -2>
}
