#version 3.8;
// Names of the innermost and of the outermost scope.
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 45 }
light_source { <-4, 6, -6>, 1 }

#declare Size = 1;
#declare Paint = pigment { rgb <0.3, 0.5, 0.9> }
#macro Pair()
    #local Size = 0.5;
    #local Paint = pigment { rgb <0.9, 0.6, 0.2> }
    sphere { -1.2*x, global.Size pigment { global.Paint } }
    sphere { 1.2*x, local.Size pigment { local.Paint } }
    #declare global["Count"] = 2;
#end
Pair()
box { <-0.1*Count, -1, 0>, <0.1*Count, 1, 0.2> pigment { rgb 0.8 } }
