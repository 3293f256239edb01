#version 3.8;
// A torus that crosses itself, cut open: union, merge, difference, intersection; a negative radius turns one inside out.
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, 0, 0.3> angle 44 }
light_source { <3, 9, -7>, rgb 1 }
light_source { <-5, 3, -6>, rgb 0.4 shadowless }
#declare Look = texture { pigment { rgb <0.9, 0.6, 0.3> } finish { ambient 0.15 diffuse 0.6 specular 0.3 } }
#declare Glass = texture { pigment { rgbt <0.5, 0.8, 0.9, 0.6> } finish { ambient 0.2 diffuse 0.5 } }
#declare Inner = texture { pigment { rgb <0.4, 0.5, 0.9> } finish { ambient 0.15 diffuse 0.6 } }
#declare Front = plane { -z, 0.15 }
intersection { torus { 0.5, 0.8 union texture { Look } } object { Front texture { Inner } } translate <-2.6, 0, 1.2> }
intersection { torus { 0.5, 0.8 merge texture { Look } } object { Front texture { Inner } } translate <0, 0, 1.2> }
intersection { torus { 0.5, 0.8 difference texture { Look } } object { Front texture { Inner } } translate <2.6, 0, 1.2> }
torus { 0.5, 0.8 intersection sturm texture { Look } translate <-2.6, 0, -1.6> }
torus { 0.5, 0.8 texture { Glass } interior_texture { Inner } rotate 60*x translate <0, 0, -1.6> }
difference { box { <-1, -0.6, -0.8>, <1, 0.4, 0.8> texture { Inner } } torus { 0.4, 0.6 difference texture { Look } } translate <2.6, 0, -1.6> }
