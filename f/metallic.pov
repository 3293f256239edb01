// Highlights in the colour of the metal, by half and in full, with phong and specular.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.4, -6> look_at <0, 0.5, 0> angle 52 }
light_source { <-3, 5, -5> rgb 1 }

#declare Gold = pigment { rgb <0.9, 0.6, 0.2> }
sphere { <-2.2, 0.5, 0>, 0.5 pigment { Gold } finish { phong 1 phong_size 15 } }
sphere { <-1.1, 0.5, 0>, 0.5 pigment { Gold } finish { phong 1 phong_size 15 metallic 0.5 } }
sphere { <0, 0.5, 0>, 0.5 pigment { Gold } finish { phong 1 phong_size 15 metallic } }
sphere { <1.1, 0.5, 0>, 0.5 pigment { Gold } finish { specular 1 roughness 0.05 metallic } }
sphere { <2.2, 0.5, 0>, 0.5 pigment { Gold } finish { reflection { 0.7 metallic } phong 1 metallic diffuse 0.3 } }
plane { y, 0 pigment { checker rgb 0.8, rgb <0.3, 0.4, 0.6> } }
plane { -z, -6 pigment { rgb <0.6, 0.8, 0.9> } }
