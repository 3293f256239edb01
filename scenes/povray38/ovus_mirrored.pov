#version 3.8;
// Eggs with the larger sphere on top: where the arc's middle would lie below that sphere's, POV-Ray 3.8 draws it above.
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -6> look_at <0, 0.4, 0> angle 50 }
light_source { <-4, 6, -6>, 1 }
ovus { 0.4, 0.7 radius 1.7 distance 1.2 translate <-1.6, -0.5, 0> pigment { rgb <0.9, 0.8, 0.5> } }
ovus { 0.5, 0.65 translate -0.3*y pigment { rgb <0.6, 0.8, 0.9> } finish { phong 0.5 } }
difference {
  ovus { 0.5, 0.9 radius 1.8 distance 0.7 }
  plane { z, -0.2 }
  translate <1.6, -0.4, 0> pigment { rgb <0.8, 0.5, 0.5> }
}
plane { y, -1 pigment { checker rgb 0.4 rgb 0.7 } }
