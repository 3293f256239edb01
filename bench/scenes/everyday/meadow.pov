// A meadow: copies of patches of copies of tufts, under an area light.
// bench: +W640 +H480 -A
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,1.2,-5> look_at <0,0.5,0> angle 45 }
light_source { <10,15,-10> rgb 1.2 area_light 2*x,2*z,4,4 adaptive 1 }
#declare R=seed(7);
#declare Tuft=union { #for (K,0,24) cone { 0,0.015,<0.12*(rand(R)-0.5),0.3+0.2*rand(R),0.12*(rand(R)-0.5)>,0 translate <0.3*(rand(R)-0.5),0,0.3*(rand(R)-0.5)> } #end }
#declare Patch=union { #for (K,0,30) object { Tuft rotate 360*rand(R)*y translate <2*(rand(R)-0.5),0,2*(rand(R)-0.5)> } #end }
union { #for (I,-5,5) #for (J,-1,8) object { Patch rotate 90*int(4*rand(R))*y translate <I*1.6,0,J*1.6> } #end #end pigment { gradient y color_map { [0 rgb <0.1,0.25,0.05>][1 rgb <0.5,0.7,0.2>] } scale 0.5 } }
plane { y,0 pigment { rgb <0.25,0.2,0.1> } }
sky_sphere { pigment { gradient y color_map { [0 rgb 0.9][1 rgb <0.2,0.4,0.9>] } } }
sphere { <0,0.6,0.5>,0.6 pigment { rgb 0.9 } finish { reflection 0.5 } }
