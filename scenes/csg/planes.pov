// Planes as operands: half-spaces cut wedges and slabs; an unbounded difference makes the ground.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.5, 2.5, -5.5> look_at <0, 0, 0> angle 42 }
light_source { <3, 6, -4> rgb 1 }
background { rgb <0.55, 0.65, 0.8> }

intersection {
  sphere { 0, 1.2 pigment { rgb <0.85, 0.35, 0.3> } }
  plane { <1, 0.5, -1>, 0.5 pigment { rgb <0.95, 0.9, 0.4> } }
  plane { <-1, 0.7, -1>, 0.5 pigment { rgb <0.4, 0.8, 0.5> } }
  plane { <0, 1, 0>, 0.7 pigment { rgb <0.4, 0.5, 0.9> } }
}
difference {
  plane { y, -0.9 }
  plane { z, -1.3 }                    // no ground in front of here
  sphere { <-2, -0.9, -1>, 0.7 }
  sphere { <2, -0.9, -0.5>, 0.9 }
  pigment { rgb <0.6, 0.55, 0.45> }
}
