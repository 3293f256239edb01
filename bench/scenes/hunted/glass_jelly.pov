// One blob of sixty wide balls that overlap, clear: every ray passes dozens of parts, again behind every face.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 1.03 s, Whittle 0.61 s.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1.5, -5> look_at 0 angle 45 }
light_source { <-6, 8, -7>, 1 }
background { rgb <.5, .6, .8> }
#declare S = seed(3);
blob {
  threshold .6
  #for (I, 1, 60) sphere { <rand(S), rand(S), rand(S)>*2 - 1, .8, .3 } #end
  pigment { rgbf <.9, .5, .6, .9> }
  interior { ior 1.3 }
}
plane { y, -1.5 pigment { checker rgb .4, rgb .8 } }
