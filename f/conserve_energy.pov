// conserve_energy: what is reflected is not let through as well.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 }
camera { location <0, 1.6, -6> look_at <0, 0.6, 0> angle 46 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.6, 0.75, 0.9> }

sphere { <-1, 0.7, 0>, 0.7 pigment { rgbf <0.9, 0.9, 1, 0.9> } finish { reflection { 0.6 } ambient 0 diffuse 0.1 } }
sphere { <1, 0.7, 0>, 0.7 pigment { rgbf <0.9, 0.9, 1, 0.9> } finish { reflection { 0.6 } conserve_energy ambient 0 diffuse 0.1 } }
plane { y, 0 pigment { checker rgb <0.9, 0.8, 0.6>, rgb <0.4, 0.2, 0.2> } }
