// area_illumination lights by every point of the area light, not by its middle: highlights and falling off become wide.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3.4, -6> look_at <0, 0.4, 0> angle 46 }
plane { y, -0.5 pigment { rgb 0.9 } finish { specular 0.6 roughness 0.01 } }
sphere { <-1.2, 0.3, 0>, 0.5 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 0.8 phong_size 60 } }
box { <0.5, -0.5, -0.4>, <1.2, 0.7, 0.3> pigment { rgb <0.3, 0.5, 0.9> } }
light_source { <0, 1.6, 0.5>, 1 area_light <5, 0, 0>, <0, 0, 2>, 5, 3 area_illumination on }
