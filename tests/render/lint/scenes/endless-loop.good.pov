#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6>, 1 }
#declare I = 0;
#while (I < 3)
  sphere { I*x, 0.3 pigment { rgb 1 } }
  #declare I = I + 1;
#end
#while (true)
  #if (I > 5) #break #end
  #declare I = I + 1;
#end
#macro Step() #declare I = I + 1; #end
#while (I < 9) Step() #end
