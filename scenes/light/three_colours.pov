// Three coloured lights: their shadows mix to the complements.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3.5, -6> look_at <0, 0.3, 0> angle 48 }
light_source { <-4, 6, -3> rgb <1, 0.1, 0.1> }
light_source { <0, 6, -4> rgb <0.1, 1, 0.1> }
light_source { <4, 6, -3> rgb <0.1, 0.1, 1> }

sphere { <0, 0.8, 0>, 0.8 pigment { rgb 1 } }
cylinder { <-2, 0, 0.5>, <-2, 1.4, 0.5>, 0.3 pigment { rgb 1 } }
cone { <2, 0, 0.5>, 0.5, <2, 1.4, 0.5>, 0 pigment { rgb 1 } }
plane { y, 0 pigment { rgb 0.9 } finish { ambient 0 } }
