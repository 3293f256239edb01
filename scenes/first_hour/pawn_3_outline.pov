// First hour, pawn, step 3: one smooth outline, turned on a lathe.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3, -7> look_at <0, 1.2, 0> angle 32 }
light_source { <-5, 8, -6> rgb 1 }
background { rgb <0.55, 0.62, 0.70> }
plane { <0, 1, 0>, 0 pigment { rgb <0.60, 0.60, 0.58> } }

#declare Pawn = lathe {
  bezier_spline 20,
  <0.00, 0.00>, <0.30, 0.00>, <0.60, 0.00>, <0.80, 0.00>     // bottom
  <0.80, 0.00>, <0.90, 0.10>, <0.90, 0.30>, <0.70, 0.35>     // rim of the foot
  <0.70, 0.35>, <0.35, 0.50>, <0.28, 1.00>, <0.24, 1.50>     // body
  <0.24, 1.50>, <0.60, 1.52>, <0.60, 1.64>, <0.26, 1.66>     // collar
  <0.26, 1.66>, <0.66, 1.85>, <0.55, 2.50>, <0.00, 2.50>     // head
}

object {
  Pawn
  pigment { rgb <0.85, 0.70, 0.50> }
}
