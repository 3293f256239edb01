// Tori whose tube is wider than their ring, so that they cross themselves, of clear glass.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 0.83 s, Whittle 1.49 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 45 }
light_source { <-6, 8, -7>, 1 }
background { rgb <.5, .6, .8> }
#declare S = seed(3);
#for (I, 1, 40)
  torus {
    .2, .25
    pigment { rgbf <.8, .9, 1, .8> }
    rotate <360*rand(S), 360*rand(S), 0>
    translate <rand(S)*4 - 2, rand(S)*2 - 1, rand(S)*3>
  }
#end
plane { y, -1 pigment { checker rgb .4, rgb .8 } }
