// diffuse from none to more than all, and brilliance that tightens it.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.4, -6> look_at <0, 0.8, 0> angle 52 }
light_source { <-3, 5, -5> rgb 1 }

#for (I, 0, 4)
  sphere { <-2.2 + 1.1*I, 0.5, 0>, 0.5 pigment { rgb <0.9, 0.7, 0.5> } finish { diffuse 0.3*I } }
  sphere { <-2.2 + 1.1*I, 1.7, 0>, 0.5 pigment { rgb <0.5, 0.7, 0.9> } finish { diffuse 0.8 brilliance 0.5*pow(2, I) } }
#end
plane { y, 0 pigment { rgb 0.6 } }
