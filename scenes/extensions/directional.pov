// Light from one direction everywhere, however far the scene reaches: docs/extensions.md. POV-Ray takes a parallel light far off.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 2.2, -6> look_at <0, 0.7, 0> angle 40 }
background { rgb <0.35, 0.45, 0.6> }
light_source { -<1, -2, 1.5>*1e4 rgb 1 #ifdef (Whittle) whittle_directional <1, -2, 1.5> #else parallel point_at 0 #end }
plane { y, 0 pigment { rgb 0.7 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 1.4, 0>, 0.2 pigment { rgb <0.8, 0.3, 0.2> } }
#end
