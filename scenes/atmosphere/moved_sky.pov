// Transformations of a sky_sphere also move the pigments written after them, in a copy of a declared one too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> look_at 0 right 2*x up 1.5*y angle 90 }
light_source { <-5, 8, -9> 1 }
sphere { 0, 0.8 pigment { rgb <0.8, 0.4, 0.2> } finish { reflection 0.5 } }
#declare Lower = sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.9, 0.6, 0.3>] [0.5 rgb <0.3, 0.5, 0.9>] } }
  scale <0.3, 0.6, 1>
}
sky_sphere {
  Lower
  rotate 20*z
  pigment { radial frequency 3 color_map { [0 rgbft <0.9, 0.9, 0.8, 0.5, 0.2>] [0.5 rgbt 1] [1 rgbf <0.2, 0.3, 0.6, 0.9>] } translate <-0.3, 0.1, -0.7> }
}
