// Differences nested eight deep: each level bites the last one, mirrored and turned; 49 copies.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <4, 9, -14> look_at <0, 0, -0.5> angle 46 }
light_source { <10, 20, -15> rgb 1 }
background { rgb <0.5, 0.55, 0.6> }

#macro Bitten(Depth)
  #if (Depth = 0)
    box { -0.9, 0.9 }
  #else
    difference {
      intersection {
        object { Bitten(Depth - 1) }
        sphere { 0, 1.25 + 0.02*Depth }
      }
      sphere { <0.95*sin(Depth*2.1), 0.9*cos(Depth*1.3), 0.95*cos(Depth*2.1)>, 0.45 pigment { rgb <0.3 + 0.07*Depth, 0.5, 0.9 - 0.07*Depth> } }
      cylinder { <-2, 0.3*sin(Depth), 0>, <2, 0.3*cos(Depth), 0>, 0.14 rotate <0, 47*Depth, 31*Depth> }
    }
  #end
#end
#declare Stone = object { Bitten(8) }
#for (X, -3, 3)
  #for (Z, -3, 3)
    object { Stone pigment { rgb <0.85, 0.8, 0.7> } rotate <23*X, 31*Z, 0> translate <2.1*X, 0, 2.1*Z> }
  #end
#end
plane { y, -1.5 pigment { rgb 0.6 } }
