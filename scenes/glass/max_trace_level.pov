// Two facing mirrors: after three reflections the ray ends.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 4 }
camera { location <0.6, 1.4, -3> look_at <0, 0.8, 0> angle 60 }
light_source { <0, 4, -1.5> rgb 1 }
background { rgb <0.4, 0.2, 0.5> }

box { <-2.5, 0, 1.9>, <2.5, 2.4, 2> pigment { rgb 0 } finish { reflection 0.9 } }
box { <-2.5, 0, -4>, <2.5, 2.4, -3.9> pigment { rgb 0 } finish { reflection 0.9 } }
sphere { <-0.6, 0.5, 0.4>, 0.5 pigment { rgb <0.9, 0.6, 0.3> } }
plane { y, 0 pigment { checker rgb 0.8, rgb <0.3, 0.5, 0.5> } }
