#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6>, 1 }
sphere { 0, 1 pigment { rgb 1 } }
box { <2, 0, 0>, <3, 0, 0> pigment { rgb 1 } }  // here
