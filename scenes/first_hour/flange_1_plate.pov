// First hour, flange, step 1: a camera, a light and a round plate.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 5, -7> look_at <0, 0.3, 0> angle 36 }
light_source { <-6, 9, -5> rgb 1 }
background { rgb <0.20, 0.23, 0.28> }

cylinder {
  <0, 0, 0>, <0, 0.4, 0>, 2
  pigment { rgb <0.75, 0.77, 0.80> }
}
