#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6>, 1 }
sphere { 0, 1 pigment { rgbt <1, 1, 1, 0.9> } }
light_source { 0, 1 }
sphere { 2*x, 1 pigment { rgb 1 } no_shadow }
light_source { 2*x, 1 }
light_source { -2*x, 1 looks_like { sphere { 0, 0.1 pigment { rgb 1 } } } }
