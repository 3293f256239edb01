// Fog dims lights with media_attenuation wherever their rays are inside of nothing solid, unless media_interaction is off.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at 0 angle 50 }
background { rgb <0.3, 0.5, 0.8> }
light_source { <-5, 9, -5> rgb 1 media_attenuation on }
light_source { <5, 6, -3> rgb <0.4, 0.9, 0.4> media_attenuation on spotlight radius 20 falloff 40 point_at 0 }
light_source { <8, 9, -5> rgb <0, 0, 1> media_attenuation on media_interaction off }
light_source { <-3, 3, 4> rgb <0.6, 0, 0> shadowless media_attenuation on }
fog { distance 20 rgbf <0.4, 0.6, 0.2, 0.5> }
fog { fog_type 2 distance 8 rgb <0.8, 0.7, 0.6> fog_offset 0 fog_alt 1 }
plane { y, -1 pigment { checker rgb 1, rgb 0.5 } }
sphere { <-1.5, 0, 0>, 1 pigment { rgb 1 } finish { phong 0.6 } }
box { <-0.5, -1, -1>, <0.5, 1, 0> pigment { rgbt <0.9, 0.8, 0.8, 0.7> } }
sphere { <2, 1, 0>, 1.2 pigment { rgbf 0.8 } interior { ior 1.2 } hollow }
