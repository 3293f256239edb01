// A matte ground under a polish that mirrors 4 % head-on: docs/extensions.md. In POV-Ray the mirror and the ground do not share the light.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 2.2, -6> look_at <0, 0.7, 0> angle 40 }
background { rgb <0.35, 0.45, 0.6> }
light_source { <-5, 8, -6> rgb 1 }
#declare Polish = finish { #ifdef (Whittle) diffuse 0.8 whittle_polished 0.04 #else diffuse 0.8 reflection { 0.04, 1 falloff 5 } #end }
plane { y, 0 pigment { rgb <0.7, 0.4, 0.2> } finish { Polish } }
sphere { <-1, 0.8, 0>, 0.8 pigment { rgb <0.2, 0.3, 0.8> } finish { Polish } }
sphere { <1, 0.8, 0>, 0.8 pigment { rgb <0.2, 0.3, 0.8> } finish { diffuse 0.8 } }
