// Points out of focus take the shape of a pigment: a ring, brighter to one side.
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  location <0, 0, -6> look_at 0 angle 40
  aperture 1.2 focal_point <0, 0, 0> blur_samples 60 variance 0
  bokeh {
    pigment {
      onion scale 0.5 translate <0.5, 0.5, 0>
      color_map { [0 rgb 0] [0.6 rgb 0] [0.6 rgb 0.4] [1 rgb 1] }
    }
  }
}
light_source { <-5, 9, -5>, 1 }
background { rgb <0.05, 0.05, 0.15> }
#for (I, 0, 11)
  sphere {
    <mod(I, 4)*1.6 - 2.4, div(I, 4)*1.4 - 1.4, 4>, 0.07
    pigment { rgb <1, 0.4 + 0.05*I, 0.3> } finish { emission 1.5 diffuse 0 }
  }
#end
sphere { 0, 0.6 pigment { checker rgb 1 rgb <0.8, 0.2, 0.2> scale 0.15 } }
