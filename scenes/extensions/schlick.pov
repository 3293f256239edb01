// Glass and metal by Fresnel's law and by Schlick's approximation of it: docs/extensions.md. In POV-Ray both rows are Fresnel's.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 2.2, -6> look_at <0, 0.7, 0> angle 40 }
background { rgb <0.35, 0.45, 0.6> }
light_source { <-5, 8, -6> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8, rgb 0.15 } }
#for (I, 0, 3)
  sphere { <1.3*I - 1.95, 0.55, 0.9>, 0.5 pigment { rgb 0.02 } finish { reflection { 0, 1 fresnel } } interior { ior 1.3 + 0.6*I } }
  sphere { <1.3*I - 1.95, 0.55, -0.9>, 0.5 pigment { rgb 0.02 }
    finish { reflection { 0, 1 #ifdef (Whittle) whittle_schlick #else fresnel #end } } interior { ior 1.3 + 0.6*I } }
#end
