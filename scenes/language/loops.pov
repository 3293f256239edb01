// #while, #for with a step and backwards, #break, #switch with ranges.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 4, -7> look_at <0, 0, 0> angle 48 }
light_source { <3, 8, -6> rgb 1 }
background { rgb <0.2, 0.2, 0.25> }

#for (X, -3, 3, 0.75)
  #declare Z = 2;
  #while (Z > -3)
    #switch (X*X + Z*Z)
      #range (0, 2)
        sphere { <X, 0, Z>, 0.35 pigment { rgb <0.9, 0.5, 0.2> } }
      #break
      #range (2, 6)
        box { <X - 0.25, -0.3, Z - 0.25>, <X + 0.25, 0.1, Z + 0.25> pigment { rgb <0.4, 0.7, 0.4> } }
      #break
      #case (9)
        cone { <X, -0.3, Z>, 0.3, <X, 0.8, Z>, 0 pigment { rgb <0.9, 0.2, 0.3> } }
      #break
      #else
        sphere { <X, -0.15, Z>, 0.15 pigment { rgb <0.5, 0.5, 0.9> } }
    #end
    #declare Z = Z - 0.75;
  #end
#end
#for (I, 10, 0, -1)
  #if (I < 4) #break #end
  sphere { <-3.5 + I*0.5, 1.5, 2.5>, 0.05*(I - 3) pigment { rgb 0.9 } }
#end
