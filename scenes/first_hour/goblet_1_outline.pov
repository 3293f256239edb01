// First hour, goblet, step 1: the outside of a goblet, drawn as half an outline and turned on a lathe.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 5, -9> look_at <0.5, 1.9, 0> angle 38 }
light_source { <-6, 9, -6> rgb 1 }
background { rgb <0.75, 0.80, 0.85> }
plane { <0, 1, 0>, -0.01 pigment { checker rgb 0.9, rgb <0.45, 0.52, 0.65> translate <0.5, 0, 0.5> } }

#declare Outside = lathe {
  bezier_spline 24,
  <0.00, 0.00>, <0.40, 0.00>, <0.80, 0.00>, <1.10, 0.00>     // bottom
  <1.10, 0.00>, <1.16, 0.04>, <1.12, 0.10>, <1.00, 0.12>     // rim of the foot
  <1.00, 0.12>, <0.30, 0.20>, <0.12, 0.35>, <0.12, 0.90>     // stem
  <0.12, 0.90>, <0.12, 1.50>, <0.10, 1.70>, <0.25, 1.85>
  <0.25, 1.85>, <1.00, 2.15>, <1.35, 2.90>, <1.00, 4.00>     // bowl
  <1.00, 4.00>, <0.70, 4.00>, <0.30, 4.00>, <0.00, 4.00>     // top, still closed
}

object {
  Outside
  pigment { rgb <0.55, 0.65, 0.75> }
  finish { specular 0.6 roughness 0.01 }
}
