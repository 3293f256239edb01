// A globe and a tyre under one drawn picture each, interpolated: sampled while reading, then asked point by point.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 1.00 s, Whittle 0.72 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 45 }
light_source { <-6, 8, -7>, 1 }
background { rgb <.5, .6, .8> }
#macro Drawn(Kind, Shape)
  pigment {
    image_map {
      function 700, 700 { pigment { wood turbulence .2 scale .2 color_map { [0 rgb <.1, .2, .4>] [.5 rgb .6] [1 rgb <1, .9, .7>] } } }
      interpolate Kind
      map_type Shape
    }
  }
#end
sphere { 0, 1.2 Drawn(4, 1) translate <-1, .2, 1> }
torus { 1, .4 Drawn(2, 5) rotate -60*x translate <1, 0, -1> }
plane { y, -1 Drawn(3, 0) }
