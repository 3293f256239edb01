// Balls with bumps of a picture of their own, drawn by a function: most is done while reading, a place at a time.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 0.91 s, Whittle 1.04 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 angle 40 }
light_source { <-6, 8, -7>, 1 }
#declare S = seed(3);
#for (I, 1, 24)
  sphere {
    <rand(S)*4 - 2, rand(S)*3 - 1.5, rand(S)>, .5
    pigment { rgb <.7, .8, .6> }
    normal {
      bump_map {
        function 448, 448 { pigment { leopard scale .01 + .02*rand(S) } }
        bump_size 2
        interpolate 4
      }
    }
  }
#end
