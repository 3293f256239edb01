#version 3.8;
// Metal's highlights: of `specular` tinted by the angle to the halfway vector, of `phong` by that to the normal, and both at once.
global_settings { assumed_gamma 1 }
camera { location <0, 1, -7> look_at 0 angle 50 }
light_source { <-5, 3, -1>, rgb 1 }
light_source { <4, 6, 8>, rgb <0.6, 0.7, 0.9> }
#declare Gold = <0.7, 0.45, 0.1>;
plane { y, -1.2 pigment { rgb Gold } finish { diffuse 0.2 specular 0.8 roughness 0.05 metallic } }
sphere { <-2.2, 0, 0>, 1 pigment { rgb Gold } finish { diffuse 0.2 specular 1 roughness 0.2 metallic } }
sphere { <0, 0, 0>, 1 pigment { rgb Gold } finish { diffuse 0.2 phong 0.8 phong_size 5 metallic } }
sphere { <2.2, 0, 0>, 1 pigment { rgb Gold } finish { diffuse 0.2 specular 0.7 roughness 0.1 phong 0.6 phong_size 4 metallic 0.8 reflection { 0.2 metallic } } normal { bumps 0.3 scale 0.2 } }
