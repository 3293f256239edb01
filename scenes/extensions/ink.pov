// Silhouettes and creases as ink lines: docs/extensions.md. POV-Ray draws none.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 2.2, -6> look_at <0, 0.7, 0> angle 40 }
background { rgb <0.35, 0.45, 0.6> }
light_source { <-5, 8, -6> rgb 1 }
#declare Ink = finish { #ifdef (Whittle) whittle_ink 0.15 #end }
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0.6 diffuse 0.4 } }
torus { 0.7, 0.25 rotate 60*x translate <-1.1, 0.85, 0> pigment { rgb <0.9, 0.8, 0.6> } finish { Ink } }
difference {
  box { <0.2, 0, -0.8>, <1.8, 1.6, 0.8> }
  sphere { <0.2, 1.6, -0.8>, 0.8 }
  cylinder { <1, 0.5, -1>, <1, 0.5, 1>, 0.3 }
  pigment { rgb <0.6, 0.8, 0.9> } finish { Ink }
}
