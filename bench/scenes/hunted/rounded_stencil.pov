// Two colours by what is inside of sixty rounded boxes: an object pattern takes powers for every box and point.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 0.42 s, Whittle 0.75 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 angle 45 }
light_source { <-6, 8, -7>, 1 }
#declare S = seed(3);
#declare Sweets = union {
  #for (I, 1, 60)
    superellipsoid { <.3, .2> scale .3 rotate <360*rand(S), 360*rand(S), 0> translate <rand(S)*4 - 2, rand(S)*3 - 1.5, 0> }
  #end
}
plane { z, 0 pigment { object { Sweets rgb <.2, .3, .5>, rgb <.9, .7, .5> } } }
