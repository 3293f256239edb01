// phong strength and size.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.4, -6> look_at <0, 0.8, 0> angle 52 }
light_source { <-3, 5, -5> rgb 1 }
light_source { <4, 2, -5> rgb <0.4, 0.2, 0.1> }

#for (I, 0, 4)
  sphere { <-2.2 + 1.1*I, 0.5, 0>, 0.5 pigment { rgb <0.6, 0.3, 0.3> } finish { phong 0.2 + 0.2*I } }
  sphere { <-2.2 + 1.1*I, 1.7, 0>, 0.5 pigment { rgb <0.3, 0.4, 0.6> } finish { phong 0.7 phong_size 5*pow(2.5, I) } }
#end
plane { y, 0 pigment { rgb 0.6 } }
