#version 3.8;
// Lemons cut, clipped, open and hollow, of glass, and one within a blob of others.
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1.5, -6> look_at 0 angle 45 }
light_source { <-4, 6, -6>, 1 }
difference { lemon { -0.9*x, 0, 0.9*x, 0, 1.2 } sphere { -0.5*z, 0.45 } translate <-1.5, 0.6, 0> pigment { rgb <0.9, 0.8, 0.2> } }
lemon { -0.7*y, 0.3, 0.7*y, 0.2, 1 open clipped_by { plane { z, 0.15 inverse } } translate <0, 0.4, 0> pigment { rgb <0.5, 0.8, 0.3> } finish { ambient 0.2 } }
lemon { -0.7*y, 0.2, 0.7*y, 0.2, 0.9 translate <1.5, 0.5, 0> pigment { rgbt <0.9, 0.9, 1, 0.8> } finish { specular 0.5 } interior { ior 1.4 } }
merge { lemon { -0.8*x, 0.1, 0.8*x, 0.1, 1.1 } lemon { -0.8*z, 0.1, 0.8*z, 0.1, 1.1 } translate -0.7*y pigment { rgb <0.8, 0.5, 0.7> } }
plane { y, -1.2 pigment { checker rgb 0.4 rgb 0.7 } }
