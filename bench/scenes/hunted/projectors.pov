// A hundred lights that shine through balls: each asks for its own object's face at every point.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 0.73 s, Whittle 0.49 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 45 }
#declare S = seed(3);
#for (I, 1, 100)
  light_source {
    <rand(S)*12 - 6, 6, rand(S)*12 - 6>, rgb .04
    projected_through { sphere { <rand(S)*4 - 2, 2, rand(S)*4 - 2>, .7 } }
  }
#end
#for (I, 1, 30) sphere { <rand(S)*4 - 2, rand(S)*2 - 1, rand(S)*3>, .3 pigment { rgb <1, .9, .7> } finish { phong .5 } } #end
plane { y, -1 pigment { checker rgb .4, rgb .8 } }
