// One blob of a hundred thousand cylinders: twigs that fork until they are too short.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Count = 0;
#macro Twig(From, Along, Level)
  #local To = From + Along;
  cylinder { From, To, 0.1*vlength(Along), 1 pigment { rgb <Level/15, 0.3, 0.2> } }
  #declare Count = Count + 1;
  #if (Level > 0)
    Twig(To, vrotate(Along, <0, 40, 25>)*0.8, Level - 1)
    Twig(To, vrotate(Along, <15, -50, -20>)*0.75, Level - 1)
  #end
#end
blob {
  threshold 0.5
  Twig(<0, 0, 0>, <0, 1, 0>, 15)
  Twig(<1, 0, 0>, <0, 1, 0.2>, 14)
  pigment { rgb <0.4, 0.3, 0.2> }
}
#debug concat("total ", str(Count, 0, 0), "\n")
camera { location <0, 3, -8> look_at <0, 2, 0> }
light_source { <10, 20, -20>, rgb 1 }
