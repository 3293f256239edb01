// Text objects: signs with a number on each.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare I = 0;
#while (I < 6000)
  text { ttf "timrom.ttf", concat("Sign number ", str(I, 0, 0), " of the street"), 0.1, 0
    pigment { rgb <0.2, 0.4, 0.8> } translate <mod(I, 60)*12, div(I, 60)*2, 0> }
  #declare I = I + 1;
#end
#debug concat("total ", str(I, 0, 0), "\n")
camera { location <300, 60, -400> look_at <300, 60, 0> }
light_source { <100, 200, -200>, rgb 1 }
