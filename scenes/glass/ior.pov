// Spheres of the same glass with ior 1, 1.1, 1.33 and 1.8, and one below 1.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 }
camera { location <0, 1.4, -6> look_at <0, 0.6, 0> angle 52 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.6, 0.75, 0.9> }

#macro Ball(I, N) sphere { <-2.2 + 1.1*I, 0.6, 0>, 0.5 pigment { rgbf <0.95, 0.98, 0.95, 0.95> } finish { phong 0.6 diffuse 0.05 ambient 0 } interior { ior N } } #end
Ball(0, 1)
Ball(1, 1.1)
Ball(2, 1.33)
Ball(3, 1.8)
Ball(4, 0.85)
plane { y, 0 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.6> } }
