// Reflection that grows towards the rim: min and max, falloff, fresnel, exponent.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.6, -6> look_at <0, 0.6, 0> angle 54 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.6, 0.75, 0.9> }

#macro Ball(I, F) sphere { <-2.4 + 1.2*I, 0.6, 0>, 0.55 pigment { rgb <0.3, 0.1, 0.1> } finish { F } interior { ior 1.6 } } #end
Ball(0, finish { reflection { 0.1, 0.9 } })
Ball(1, finish { reflection { 0, 1 falloff 4 } })
Ball(2, finish { reflection { 0, 1 fresnel } })
Ball(3, finish { reflection { rgb <0.1, 0, 0>, rgb <0.4, 0.8, 1> fresnel on } conserve_energy })
Ball(4, finish { reflection { 0.8 exponent 0.5 } })
plane { y, 0 pigment { checker rgb 0.9, rgb 0.3 } }
