// Inside a prism and a cube of glass, light meets the far side too flatly and is reflected in full.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 10 }
camera { location <0.5, 2, -5> look_at <0, 0.5, 0> angle 44 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.55, 0.7, 0.85> }

#declare Clear = texture { pigment { rgbf <0.97, 0.99, 0.98, 1> } finish { ambient 0 diffuse 0 specular 0.4 } }
intersection {
  plane { <0, 1, -1>, 0.6 }
  plane { -y, 0 }
  plane { z, 0.6 }
  plane { x, 0.8 }
  plane { -x, 0.8 }
  texture { Clear } interior { ior 1.5 }
  rotate 30*y
  translate -1*x
}
box { <0.5, 0.01, -0.5>, <1.5, 1, 0.5> texture { Clear } interior { ior 1.5 } rotate -10*y }
plane { y, 0 pigment { checker rgb <0.9, 0.85, 0.7>, rgb <0.5, 0.2, 0.2> scale 0.5 } }
