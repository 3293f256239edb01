#version 3.8;
// The field of blobs and of a surface, less its threshold and without, as bumps, as a map of textures and with a wave.
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 66 }
light_source { <-4, 6, -6>, 1 }
#declare Drops = blob { threshold 0.5 sphere { <-0.3, 0.2, -0.8>, 0.7, 1 } sphere { <0.4, -0.2, -0.8>, 0.6, 1.5 } sphere { <0, 0.7, -0.6>, 0.5, -0.7 } }
sphere { 0, 0.9 pigment { rgb <0.8, 0.7, 0.5> } normal { potential { Drops } 0.9 } translate -1.7*x }
sphere { 0, 0.9
  texture {
    potential { isosurface { function { sin(6*x) + sin(6*y) + sin(6*z) } threshold 0.4 } } threshold on
    texture_map { [-0.2 pigment { rgb <0.2, 0.5, 0.8> } finish { phong 0.6 }] [0.2 pigment { rgb <0.9, 0.9, 0.6> }] }
  }
}
sphere { 0, 0.9 pigment { rgb <0.5, 0.8, 0.6> } normal { potential { Drops } threshold on 0.8 sine_wave frequency 3 } translate 1.7*x }
