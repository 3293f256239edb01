// Difference, union and intersection in one another, six levels deep and three wide: 729 balls, most of which no ray needs.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 3.93 s, Whittle 6.15 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 45 }
light_source { <-6, 8, -7>, 1 }
background { rgb <.5, .6, .8> }
#declare S = seed(3);
#macro Tree(Level)
  #if (Level = 0)
    sphere { <rand(S), rand(S), rand(S)> - .5, .3 + .5*rand(S) }
  #else
    #switch (mod(Level, 3))
      #case (0) difference { #break
      #case (1) union { #break
      #else intersection {
    #end
    Tree(Level - 1) Tree(Level - 1) Tree(Level - 1) }
  #end
#end
object { Tree(6) pigment { rgb <.9, .7, .5> } scale 1.5 }
plane { y, -1 pigment { checker rgb .4, rgb .8 } }
