#version 3.8;
// A macro whose last two parameters may be left out.
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 angle 45 }
light_source { <-4, 6, -6>, 1 }

#macro Post(Place, optional Height, optional Colour)
    #ifndef (local.Height) #local Height = 1; #end
    #ifndef (local.Colour) #local Colour = rgb 0.7; #end
    cylinder { <Place, -1, 0>, <Place, -1 + Height, 0>, 0.4 pigment { Colour } }
#end
#declare Height = 0.1;  // of another scope: the macro does not see it
Post(-2, , )
Post(-0.7, 2, )
Post(0.7, , rgb <0.8, 0.3, 0.2>)
Post(2, 1.5, rgb <0.2, 0.4, 0.8>)
