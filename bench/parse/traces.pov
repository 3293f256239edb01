// trace() in loops: grass set down on a hilly ground and a union of stones.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Ground = union {
  #for (I, 0, 39)
    sphere { <mod(I*7, 40) - 20, -4.5, mod(I*11, 40) - 20>, 5 }
    box { <-0.5, -1, -0.5>, <0.5, 0.6, 0.5> rotate y*I*9 translate <mod(I*13, 40) - 20, 0.5, mod(I*17, 40) - 20> }
  #end
  plane { y, -1 }
}
object { Ground pigment { rgb <0.4, 0.3, 0.2> } }
#declare Count = 0;
#declare X = 0;
#while (X < 300)
  #declare Z = 0;
  #while (Z < 300)
    #declare Norm = <0, 0, 0>;
    #declare Hit = trace(Ground, <X/7.5 - 20, 20, Z/7.5 - 20>, <0.1, -1, 0.05>, Norm);
    #if (vlength(Norm) > 0 & Norm.y > 0.5)
      cone { Hit, 0.03, Hit + Norm*0.3, 0 pigment { rgb <0.1, 0.6, 0.1> } }
      #declare Count = Count + 1;
    #end
    #declare Z = Z + 1;
  #end
  #declare X = X + 1;
#end
#debug concat("total ", str(Count, 0, 0), "\n")
camera { location <0, 10, -30> look_at 0 }
light_source { <100, 200, -200>, rgb 1 }
