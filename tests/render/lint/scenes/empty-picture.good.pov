#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 2, 20> }
light_source { <5, 8, -6>, 1 }
sphere { <0, 2.3, 30>, 0.001 pigment { rgb 1 } }
