// `orient` turns the circles of parallel and cylinder lights across their rays, of others toward each point.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -6> look_at 0 angle 60 }
background { rgb <0.3, 0.5, 0.8> }
light_source { <-5, 9, -5> rgb <0.6, 0, 0> parallel point_at 0 area_light 4*x, 4*y, 5, 5 circular orient }
light_source { <6, 9, -3> rgb <0, 0.8, 0> cylinder radius 3 falloff 5 point_at 0 area_light 6*x, 6*y, 4, 4 circular orient adaptive 1 }
light_source { <0, 9, 4> rgb <0, 0, 0.6> spotlight radius 30 falloff 50 point_at 0 area_light 3*x, 3*y, 5, 5 circular orient }
plane { y, -1 pigment { rgb 1 } }
sphere { <0, 1, 0>, 0.5 pigment { rgb 1 } }
box { <-2, 0, -1>, <-1, 0.3, 1> pigment { rgb 1 } }
cylinder { <1, 0, -1>, <2, 1, 1>, 0.2 pigment { rgb 1 } }
