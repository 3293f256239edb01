// Spheres of negative radius have their boxes inside out: POV-Ray's hierarchy never finds them, unless they are stretched or are operands.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.3, 0> angle 45 }
light_source { <-5, 8, -9> 1 }
plane { y, -1.2 pigment { checker rgb 1 rgb 0.3 } }
sphere { <-2.6, 0, 0>, -0.8 pigment { rgb <1, 0.5, 0.2> } finish { reflection 0.2 } }
union { sphere { <-1, 0.3, 0>, -0.8 } box { <-0.8, -0.6, -0.8>, <0, 0.4, 0.6> } pigment { rgb <0.2, 0.9, 0.3> } }
difference { box { <0.5, -0.8, -0.8>, <2, 0.8, 0.8> } sphere { <0.9, 0.8, -0.6>, -0.7 } pigment { rgb <0.2, 0.4, 1> } }
sphere { <0, 0, 0>, -0.8 pigment { rgb <0.9, 0.1, 0.1> } scale <1, 1.6, 1> translate <3, 0.2, 0> }
sphere { <0, 1.6, 2>, -0.8 pigment { rgb <0.9, 0.9, 0.1> } clipped_by { box { 0, 3 } } }
merge { sphere { <-3, 1.6, 2>, -0.8 } sphere { <-2.4, 1.6, 2>, 0.6 } pigment { rgb <0.6, 0.4, 0.9> } }
// trace() asks the object itself, without the hierarchy.
#declare Asked = union { sphere { 0, -0.5 } sphere { 2*y, 0.2 } box { -3, -2.9 } }
sphere { trace(Asked, -5*z, z) + <-0.6, -0.4, -1.5>, 0.25 pigment { rgb <0.9, 0.5, 0.7> } }
