#version 3.8;
// A cloud whose densities of red, green and blue are functions of their own, one of them left out.
global_settings { assumed_gamma 1 }
camera { location <0, 0.6, -4> look_at 0 angle 45 }
light_source { <-4, 6, -6>, 1 }
plane { y, -1.2 pigment { checker rgb 0.3 rgb 0.8 } }
sphere {
  0, 1.1 hollow
  pigment { rgbt 1 }
  interior {
    media {
      method 2 samples 30 intervals 1
      emission 0.9
      absorption 0.4
      density { user_defined { function { max(0, 1 - sqrt(x*x + y*y + z*z)) }, , function { abs(sin(3*y))*max(0, 1 - x*x - z*z) } } }
    }
  }
}
