#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6>, 1 }
#declare Radius = 1;
#declare Written = 1;
#macro Ball(R) sphere { 0, R pigment { rgb 1 } } #end
Ball(Radius)
#debug concat("Written = ", str(Radius, 0, 0))
