// Texture maps in texture maps, five levels, whose textures bend the normal: it goes through the space of every map that was looked at before.
// Whole runs at 320x240 on 29 Nov 2026: POV-Ray 1.73 s, Whittle 1.58 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 angle 45 }
light_source { <-6, 8, -7>, 1 }
#declare S = seed(3);
#macro Leaf(Level)
  #if (Level = 0)
    pigment { rgb <rand(S), rand(S), rand(S)> } normal { bumps .3 scale .2 } finish { phong rand(S) }
  #else
    bozo scale .4 texture_map { [.3 Leaf(Level - 1)] [.6 Leaf(Level - 1)] }
  #end
#end
plane { z, 0 texture { Leaf(5) } }
