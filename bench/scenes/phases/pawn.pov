// Pawns turned on a lathe of Bezier curves, on a board that mirrors them.
// bench: +W640 +H480 -A
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
camera { location <1.5, 3.6, -6.5> look_at <0, 0.9, 0> angle 38 }
light_source { <-6, 9, -7> rgb 0.9 }
light_source { <7, 5, -2> rgb 0.35 }
background { rgb <0.55, 0.62, 0.70> }
plane { y, 0 pigment { checker rgb 0.85, rgb <0.20, 0.14, 0.10> } finish { diffuse 0.7 reflection 0.2 } }
#declare Pawn = lathe {
  bezier_spline 20,
  <0.00, 0.00>, <0.25, 0.00>, <0.48, 0.00>, <0.55, 0.02>
  <0.55, 0.02>, <0.62, 0.08>, <0.62, 0.22>, <0.50, 0.28>
  <0.50, 0.28>, <0.25, 0.45>, <0.20, 0.80>, <0.18, 1.20>
  <0.18, 1.20>, <0.38, 1.22>, <0.38, 1.30>, <0.20, 1.34>
  <0.20, 1.34>, <0.52, 1.50>, <0.36, 2.02>, <0.00, 2.02>
}
#for (X, -1, 1)
  #for (Z, 0, 2)
    object {
      Pawn
      pigment { rgb <0.80 - 0.25*mod(X + Z + 2, 2), 0.65 - 0.3*mod(X + Z + 2, 2), 0.45 - 0.25*mod(X + Z + 2, 2)> }
      finish { diffuse 0.7 specular 0.6 roughness 0.02 reflection 0.08 }
      translate <1.5*X, 0, 1.4*Z - 0.7>
    }
  #end
#end
