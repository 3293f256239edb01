// Two colours by what is inside of a union of 600 balls: an object pattern asks all of them for every point.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 0.48 s, Whittle 0.42 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 45 }
light_source { <-6, 8, -7>, 1 }
background { rgb <.5, .6, .8> }
#declare S = seed(3);
#declare Pebbles = union {
  #for (I, 1, 600) sphere { <rand(S), rand(S), rand(S)>*4 - 2, .12 + .1*rand(S) } #end
}
#declare Spotted = pigment { object { Pebbles rgb <.2, .3, .4>, rgb <.9, .8, .7> } }
sphere { 0, 1.3 pigment { Spotted } }
plane { y, -1 pigment { Spotted } }
