// Tones from cool to warm instead of light and shadow: docs/extensions.md. POV-Ray shades it as usual.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 2.2, -6> look_at <0, 0.7, 0> angle 40 }
background { rgb <0.35, 0.45, 0.6> }
light_source { <-5, 8, -6> rgb 1 }
#declare Tones = finish { ambient 0 #ifdef (Whittle) whittle_cool_warm rgb <0, 0, 0.4>, rgb <0.4, 0.4, 0> #end }
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0.6 diffuse 0.4 } }
sphere { <-1.1, 0.9, 0>, 0.9 pigment { rgb <0.7, 0.3, 0.3> } finish { Tones } }
difference {
  box { <0.2, 0, -0.8>, <1.8, 1.6, 0.8> }
  sphere { <0.2, 1.6, -0.8>, 0.8 }
  pigment { rgb <0.3, 0.6, 0.4> } finish { Tones }
}
