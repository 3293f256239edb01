// Many small objects from a macro that calls itself: balls on balls, each turned, moved and scaled.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Count = 0;
#declare Paint = texture { pigment { rgb <0.8, 0.6, 0.2> } finish { phong 0.4 } }
#declare Ball = sphere { 0, 1 texture { Paint } }
#macro Flake(Place, Size, Level)
  object { Ball scale Size translate Place }
  #declare Count = Count + 1;
  #if (Level > 0)
    #local Next = Size*0.45;
    #local Far = Size + Next;
    Flake(Place + x*Far, Next, Level - 1)
    Flake(Place - x*Far, Next, Level - 1)
    Flake(Place + y*Far, Next, Level - 1)
    cylinder { Place, Place + z*Far, Next*0.2 texture { Paint } }
    Flake(Place + z*Far, Next, Level - 1)
  #end
#end
Flake(<0, 0, 0>, 1, 8)
#debug concat("total ", str(Count, 0, 0), "\n")
camera { location <3, 4, -8> look_at 0 }
light_source { <10, 20, -20>, rgb 1 }
