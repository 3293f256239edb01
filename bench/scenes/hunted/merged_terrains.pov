// A merge of fifty small height fields, turned every way: every ray walks through all operands one by one.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 0.44 s, Whittle 0.71 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 45 }
light_source { <-6, 8, -7>, 1 }
background { rgb <.5, .6, .8> }
#declare S = seed(3);
#declare Ground = height_field {
  function 20, 20 { pattern { bozo scale .3 } }
  translate -.5
  scale <2, .8, 2>
}
merge {
  #for (I, 1, 50)
    object { Ground scale .4 rotate <360*rand(S), 360*rand(S), 0> translate <rand(S)*4 - 2, rand(S)*2 - 1, rand(S)*3> }
  #end
  pigment { rgb <.8, .9, .6> }
}
plane { y, -1 pigment { checker rgb .4, rgb .8 } }
