// Sixty layers, some of them mirrors.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at 0 angle 40 }
light_source { <-5, 9, -5>, 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, -1.5 pigment { checker rgb 1 rgb 0.3 } }
sphere {
  0, 1
  #for (I, 0, 59)
    texture {
      pigment {
        gradient x scale 0.1 + 0.03*I
        color_map {
          [0 rgbt <mod(I, 5)/4, mod(I, 7)/6, 0.5, 0.92>]
          [1 rgbt <0.1, 0.5, mod(I, 3)/2, 0.95>]
        }
      }
      finish { phong 0.05 reflection 0.02*mod(I, 4) }
    }
  #end
}
