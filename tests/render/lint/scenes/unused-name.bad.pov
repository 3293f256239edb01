#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6>, 1 }
#declare Radius = 1;
#declare Radios = 2;  // here
sphere { 0, Radius pigment { rgb 1 } }
