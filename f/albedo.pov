// diffuse, specular and phong given as albedo, and light let through a thin sheet.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.4, -6> look_at <0, 0.6, 0> angle 52 }
light_source { <-3, 5, -5> rgb 1 }
light_source { <2.2, 1, 4> rgb 1 }

sphere { <-2.2, 0.5, 0>, 0.5 pigment { rgb <0.7, 0.5, 0.3> } finish { diffuse albedo 0.7 brilliance 3 } }
sphere { <-1.1, 0.5, 0>, 0.5 pigment { rgb <0.7, 0.5, 0.3> } finish { specular albedo 0.5 roughness 0.05 } }
sphere { <0, 0.5, 0>, 0.5 pigment { rgb <0.7, 0.5, 0.3> } finish { phong albedo 0.5 phong_size 20 } }
disc { <1.6, 0.9, 0.5>, z, 0.8 pigment { rgb <0.4, 0.8, 0.4> } finish { diffuse 0.5, 0.5 } }
plane { y, 0 pigment { rgb 0.5 } }
