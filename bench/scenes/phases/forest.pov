// A forest: a hundred thousand copies of one tree.
// bench: +W800 +H600 -A
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 14, -20> look_at <0, 0, 40> angle 60 }
light_source { <-300, 400, -200> rgb 1 }
background { rgb <0.65, 0.78, 0.92> }
plane { y, 0 pigment { rgb <0.35, 0.40, 0.20> } }
#declare Tree = union {
  cylinder { 0, 0.6*y, 0.12 pigment { rgb <0.35, 0.22, 0.12> } }
  #for (I, 0, 3)
    cone { (0.5 + 0.45*I)*y, 0.75 - 0.15*I, (1.25 + 0.5*I)*y, 0.02 }
  #end
  pigment { rgb <0.12, 0.38, 0.16> }
}
#declare S = seed(71);
#for (Z, 0, 315)
  #for (X, 0, 316)
    object {
      Tree
      rotate 360*rand(S)*y
      scale 0.7 + 0.6*rand(S)
      translate <1.5*(X - 158 + 0.8*rand(S)), 0, 1.5*(Z + 0.8*rand(S))>
    }
  #end
#end
