// A merge of slabs, each of two half-spaces within a ball: thirty operands whose bounds are all the same ball.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 2.56 s, Whittle 1.31 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 40 }
light_source { <-6, 8, -7>, 1 }
background { rgb <.5, .6, .8> }
plane { y, -1 pigment { checker rgb .4, rgb .8 } }
#declare S = seed(3);
merge {
  #for (I, 1, 30)
    intersection {
      plane { x, .06 }
      plane { -x, .06 }
      sphere { 0, 1 }
      rotate 360*<rand(S), rand(S), rand(S)>
    }
  #end
  pigment { rgbf <.8, .9, 1, .8> }
  interior { ior 1.2 }
}
