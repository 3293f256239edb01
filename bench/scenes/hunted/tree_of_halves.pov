// Rooms cut out of rooms: slabs and columns of inverted half-spaces, united and cut from one another, five levels deep.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 1.59 s, Whittle 3.06 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 2, -5> look_at 0 angle 45 }
light_source { <-6, 8, -7>, 1 }
background { rgb <.5, .6, .8> }
#declare S = seed(8);
#macro Slab(A) intersection { plane { A, -.1 - .3*rand(S) inverse } plane { -A, -.1 - .3*rand(S) inverse } rotate <90*rand(S), 90*rand(S), 0> translate <rand(S) - .5, rand(S) - .5, rand(S) - .5> } #end
#macro Room(Level)
  #if (Level = 0) Slab(x)
  #else
    difference { merge { box { -.4 - rand(S), .4 + rand(S) } Slab(y) Slab(z) } merge { Room(Level - 1) Slab(x) } Room(Level - 1) }
  #end
#end
intersection { box { -1.2, 1.2 } Room(4) pigment { rgb <.9, .8, .6> } }
plane { y, -1.6 pigment { checker rgb .4, rgb .8 } }
