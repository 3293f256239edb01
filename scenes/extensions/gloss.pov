// Mirrors of four roughnesses: docs/extensions.md. POV-Ray renders all four sharp.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 2.2, -6> look_at <0, 0.7, 0> angle 40 }
background { rgb <0.35, 0.45, 0.6> }
light_source { <-5, 8, -6> rgb 1 }
#macro Rough(R) #ifdef (Whittle) whittle_gloss R, 64 #end #end
plane { y, 0 pigment { checker rgb 0.8, rgb 0.15 } finish { reflection { 0.3 Rough(0.002) } } }
#for (I, 0, 3)
  sphere { <1.3*I - 1.95, 0.6, 0>, 0.6 pigment { rgb 0.1 } finish { diffuse 0.2 reflection { 0.8 Rough(pow(0.1, 4 - I)) } } }
#end
box { <-2.5, 0, 1.5>, <2.5, 1.6, 1.7> pigment { gradient x color_map { [0.5 rgb x] [0.5 rgb <1, 0.9, 0.2>] } scale 0.5 } }
