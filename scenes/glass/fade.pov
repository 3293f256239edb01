// Absorption by depth: fade_distance, fade_power and fade_color, the exponential law from 1000 on.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 }
camera { location <0, 1.6, -6> look_at <0, 0.6, 0> angle 48 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb 1 }

#declare Clear = texture { pigment { rgbf 1 } finish { ambient 0 diffuse 0 specular 0.3 } }
sphere { <-1.7, 0.7, 0>, 0.7 texture { Clear } interior { ior 1.2 fade_distance 0.4 fade_power 2 } }
sphere { <0, 0.7, 0>, 0.7 texture { Clear } interior { ior 1.2 fade_distance 0.5 fade_power 2 fade_color rgb <0.8, 0.3, 0.1> } }
intersection {
  sphere { <1.7, 0.7, 0>, 0.8 }
  box { <1, 0.05, -0.6>, <2.4, 1.3, 0.6> }
  texture { Clear } interior { ior 1.2 fade_distance 0.7 fade_power 1001 fade_color rgb <0.2, 0.6, 0.8> }
}
plane { y, 0 pigment { checker rgb 0.9, rgb 0.6 } }
