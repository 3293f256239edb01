// Transparent solids that tell one ray only so many of their crossings: behind each begins a new ray, so all sides show and filter
// the light, on an unbent way too.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 12 }
camera { location <0, 2.5, -9> look_at <0, 0.1, 0> angle 48 }
light_source { <-5, 9, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, -1.2 pigment { checker rgb 1 rgb 0.5 } }

#declare Ball = function { x*x + y*y + z*z - 0.6 }
#declare Waves = function { sin(5*x) * sin(5*y) * sin(5*z) - 0.2 }
isosurface { function { Ball(x, y, z) } max_gradient 4 pigment { rgbt <0.9, 0.5, 0.5, 0.7> } translate <-2.6, 1.2, 0> }
isosurface { function { Waves(x, y, z) } open max_gradient 6 pigment { rgbt <0.5, 0.9, 0.5, 0.8> } scale 0.9 translate <0, 1.3, 0> }
isosurface { function { Ball(x, y, z) } max_gradient 4 pigment { rgbf <0.9, 0.9, 1, 0.8> } interior { ior 1.3 } translate <2.6, 1.2, 0> }
difference {
  isosurface { function { Ball(x, y, z) } max_gradient 4 }
  sphere { <0.5, 0.5, -0.5>, 0.5 }
  pigment { rgbt <0.5, 0.6, 0.9, 0.7> } translate <-2.2, -0.5, -1>
}
julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 20 pigment { rgbt <0.9, 0.8, 0.4, 0.8> } scale 0.8 translate <0.2, -0.4, -1> }
parametric {
  function { u } function { 0.3*sin(3*u) } function { v } <-0.8, -0.5>, <0.8, 0.5>
  contained_by { box { <-1, -1, -1>, <1, 1, 1> } } max_gradient 1 accuracy 0.02
  pigment { rgbt <0.9, 0.5, 0.9, 0.6> } rotate <-20, 30, 0> translate <2.3, -0.4, -1>
}
