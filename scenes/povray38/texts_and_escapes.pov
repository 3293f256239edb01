#version 3.8;
// Texts longer than 256 letters, letters by number, and a file's name with an escape.
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 55 }
light_source { <-4, 6, -8>, 1 }
#declare Long = "";
#for (I, 1, 60) #declare Long = concat(Long, "abcdefgh-"); #end
#declare Shown = substr(Long, 500, 5);
text { ttf "timrom.ttf" Shown, 0.3, 0 translate <-1.2, 0.6, 0> pigment { rgb <0.9, 0.6, 0.2> } }
text { ttf "timrom\u002Ettf" "\u0041\u0067" 0.3, 0 translate <-2.1, -1, 0> pigment { rgb <0.3, 0.7, 0.9> } }
text { ttf "timrom.ttf" concat(strupr("pov"), str(strlen(Long), 0, 0)) 0.3, 0 translate <-0.9, -1, 0> pigment { rgb <0.5, 0.8, 0.4> } }
plane { z, 1 pigment { rgb 0.5 } }
