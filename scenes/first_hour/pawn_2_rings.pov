// First hour, pawn, step 2: a rounded foot, a collar below the head, and a hollow below the foot that nobody sees.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3, -7> look_at <0, 1.2, 0> angle 32 }
light_source { <-5, 8, -6> rgb 1 }
background { rgb <0.55, 0.62, 0.70> }
plane { <0, 1, 0>, 0 pigment { rgb <0.60, 0.60, 0.58> } }

difference {
  union {
    cylinder { <0, 0, 0>, <0, 0.3, 0>, 0.65 }
    torus { 0.65, 0.15 translate <0, 0.15, 0> }
    cone { <0, 0.3, 0>, 0.6, <0, 1.7, 0>, 0.25 }
    sphere { <0, 0, 0>, 0.45 scale <1, 0.25, 1> translate <0, 1.6, 0> }    // collar: a flat ball
    sphere { <0, 2, 0>, 0.5 }
  }
  sphere { <0, 0, 0>, 0.4 scale <1, 0.4, 1> }                            // hollow
  pigment { rgb <0.85, 0.70, 0.50> }
}
