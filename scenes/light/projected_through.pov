// Lights projected through an object: only its outline is lit, with shadows and without; what stands between it and the
// light does not matter.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -10> look_at <0, 0.5, 0> angle 45 }
plane { y, -1 pigment { rgb <0.8, 0.8, 0.7> } }
plane { -z, -3 pigment { rgb <0.6, 0.7, 0.9> } }
sphere { <-1.2, -0.4, 0>, 0.6 pigment { rgb <0.9, 0.4, 0.2> } finish { phong 0.6 } }
box { <0.6, -1, -0.5>, <1.4, 0.4, 0.3> pigment { rgbf <0.3, 0.9, 0.4, 0.5> } }
#declare Ring = torus { 0.7, 0.25 rotate -90*x }
light_source { <-4, 6, -9> rgb <1, 0.9, 0.7> projected_through { object { Ring scale 0.8 translate <-2, 2.9, -4> } } }
light_source { <0, 0, 0> rgb <0.4, 0.6, 1> projected_through { difference { box { <-1, -1, 4>, <1, 1, 4.2> } sphere { <0, 0, 4>, 0.8 } } } shadowless rotate <35, -30, 0> translate <4, 6, -9> }
light_source { <6, 9, -9> rgb 0.35 projected_through { sphere { <2.4, 3.6, -3.4>, 1.2 } } area_light 0.5*x, 0.5*y, 3, 3 }
box { <-4, 5.2, -8.2>, <-3, 5.3, -8> no_image pigment { rgb 0 } }
