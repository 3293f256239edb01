#version 3.8;
// The field of a blob on a floor: raw in bands of its own size, and less the threshold through a wave on the wall. On the
// box the field of an isosurface with its inside out.
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at <0, 0.7, 0> angle 42 }
light_source { <4, 8, -6>, 1 }

#declare Drops = blob {
  threshold 0.5
  sphere { <-1.2, 0.6, 0>, 1.8, 1 }
  sphere { <1, 0.9, 0.4>, 1.5, 1.4 }
  cylinder { <-1, 0.1, -1>, <1.5, 0.1, -1.2>, 0.9, -0.6 }
}
#declare Saddle = isosurface { function { x*x - z*z + y/2 } threshold 0.2 contained_by { box { -1, 1 } } };
#declare Bands = color_map {
  [-0.5 rgb <0.1, 0.2, 0.5>] [0 rgb <0.3, 0.5, 0.8>] [0.01 rgb <0.8, 0.8, 0.7>] [0.5 rgb <0.9, 0.6, 0.2>]
  [0.51 rgb <0.6, 0.1, 0.1>] [1.5 rgb <1, 0.9, 0.3>]
}

object { Drops pigment { rgb <0.4, 0.7, 0.4> } finish { phong 0.5 } }
plane { y, 0 pigment { potential { Drops } color_map { Bands } } }
plane { z, 3 pigment { potential { object { Drops scale 2 } } threshold on sine_wave frequency 3 } }
box { -0.6, 0.6 pigment { potential { isosurface { Saddle inverse } } threshold on color_map { Bands } } rotate 40*y translate <2, 0.6, -1.6> }
