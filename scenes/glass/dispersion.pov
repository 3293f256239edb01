// Light parted into its colours by glass: several samples, tilted faces, one index of refraction that only bends some colours.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1.5, -6> look_at <0, 0.6, 0> angle 40 }
light_source { <-8, 12, -6> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9, rgb 0.15 scale 0.4 } }
plane { -z, -8 pigment { gradient x color_map { [0 rgb 0.05][0.5 rgb 0.05][0.5 rgb 1][1 rgb 1] } scale 0.8 } finish { ambient 0.6 diffuse 0.3 } }
#declare Glass = texture { pigment { rgbt <1, 1, 1, 0.95> } finish { specular 0.6 roughness 0.01 reflection 0.08 ambient 0 diffuse 0 } }
sphere { <-1.3, 0.8, 0>, 0.8 texture { Glass } interior { ior 1.5 dispersion 1.12 dispersion_samples 12 } }
intersection { plane { x, 0 rotate 30*z } plane { -x, 0 rotate -30*z } plane { -y, 0 } plane { z, 0.6 } plane { -z, 0.6 }
  translate <1.1, 0, 0> scale <1, 1, 1> translate 0 texture { Glass } interior { ior 1.4 dispersion 1.15 } rotate 20*y }
box { <-0.3, 0, -1.8>, <0.5, 0.5, -1.4> rotate 25*y texture { pigment { rgbf <0.8, 1, 0.9, 0.9> } finish { phong 0.5 } normal { bumps 0.2 scale 0.2 } } interior { ior 1.3 dispersion 1.05 dispersion_samples 5 } }
sphere { <0.25, 1.9, 1>, 0.5 texture { Glass } interior { ior 1 dispersion 1.2 } }
