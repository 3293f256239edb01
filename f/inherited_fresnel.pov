// Mirrors given anew in the finish of a declared texture: fresnel stays on, but only the word makes one colour the most
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -8> look_at 0 angle 50 }
background { rgb <0.55, 0.7, 0.85> }
light_source { <-8, 12, -9> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.25 } }
#declare Coat = texture { pigment { rgb <0.5, 0.2, 0.15> } finish { reflection { 0.6 fresnel } } }
#macro Ball(X, Z) sphere { <X, 0, Z>, 0.8 interior { ior 1.6 } #end
Ball(-2.8, 0) texture { Coat } }
Ball(-0.9, 0) texture { Coat finish { reflection { 0.5 } } } }
Ball(1.0, 0) texture { Coat finish { reflection { 0.5 metallic } } } }
Ball(2.9, 0) texture { Coat finish { reflection { 0.1, 0.9 } } } }
Ball(-1.9, 2.5) texture { Coat finish { reflection { 0.5 fresnel off } } } }
Ball(0, 2.5) texture { Coat finish { reflection { 0.5 fresnel } } } }
Ball(1.9, 2.5) texture { Coat finish { reflection 0.5 } } }
