// Difference with several subtracted operands: a sphere drilled along all three axes.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <2, 1.7, -3> look_at 0 angle 40 }
light_source { <2, 6, -6> rgb <1, 0.95, 0.85> }
light_source { <-6, 2, -3> rgb 0.3 }

difference {
  sphere { 0, 1 }
  cylinder { -1.1*x, 1.1*x, 0.45 pigment { rgb <0.9, 0.2, 0.2> } }
  cylinder { -1.1*y, 1.1*y, 0.45 pigment { rgb <0.2, 0.8, 0.3> } }
  cylinder { -1.1*z, 1.1*z, 0.45 pigment { rgb <0.3, 0.4, 0.9> } }
  pigment { rgb 0.85 }
}
