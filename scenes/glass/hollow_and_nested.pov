// A hollow glass ball, glass with an opaque core, and a drop of other glass within glass.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 10 }
camera { location <0, 1.6, -6> look_at <0, 0.6, 0> angle 44 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.7, 0.8, 0.9> }

#declare Clear = texture { pigment { rgbf <0.95, 1, 0.97, 0.95> } finish { ambient 0 diffuse 0.05 specular 0.5 } }
difference {
  sphere { 0, 0.7 }
  sphere { 0, 0.6 }
  texture { Clear } interior { ior 1.5 }
  translate <-1.6, 0.7, 0>
}
sphere { <0, 0.7, 0>, 0.7 texture { Clear } interior { ior 1.5 } }
sphere { <0, 0.7, 0>, 0.3 pigment { rgb <0.9, 0.3, 0.2> } }
sphere { <1.6, 0.7, 0>, 0.7 texture { Clear } interior { ior 1.33 } }
sphere { <1.6, 0.8, 0>, 0.3 texture { Clear } interior { ior 1.8 } }
plane { y, 0 pigment { checker rgb 0.85, rgb <0.3, 0.5, 0.4> } }
