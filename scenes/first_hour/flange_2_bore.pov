// First hour, flange, step 2: a plate and a neck are one solid, and a bore goes through it.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 5, -7> look_at <0, 0.3, 0> angle 36 }
light_source { <-6, 9, -5> rgb 1 }
background { rgb <0.20, 0.23, 0.28> }

difference {
  union {
    cylinder { <0, 0, 0>, <0, 0.4, 0>, 2 }    // plate
    cylinder { <0, 0, 0>, <0, 1.2, 0>, 1 }    // neck
  }
  cylinder { <0, -1, 0>, <0, 2, 0>, 0.7 }     // bore
  pigment { rgb <0.75, 0.77, 0.80> }
}
