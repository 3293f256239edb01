// One interior that several parts share: the last part's own `hollow` decides for all of them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -7> look_at 0 angle 46 }
light_source { <2, 5, -5> 1 }
plane { y, -1.4 pigment { checker rgb 1 rgb 0.5 } }
fog { distance 12 rgb <1, 0.5, 0> }
#declare Clear = texture { pigment { rgbf 1 } }
#declare Glow = interior { media { emission rgb <0.1, 0.5, 1>*0.5 } }

union { sphere { 0, 0.6 hollow } sphere { 0.9*x, 0.35 } texture { Clear } interior { Glow } translate <-2.2, 1.2, 0> }
union { sphere { 0, 0.6 } sphere { 0.9*x, 0.35 hollow } texture { Clear } interior { Glow } translate <0, 1.2, 0> }
union { sphere { 0, 0.6 hollow interior { Glow } } sphere { 0.9*x, 0.35 } texture { Clear } interior { Glow } translate <2, 1.2, 0> }
// Parts without an interior share one too: the ball that is cut away makes the second box solid.
#declare Boxes = merge {
  box { -0.6, <0.5, 0.5, 0.4> texture { Clear } interior { Glow } hollow }
  box { <-0.9, -0.4, -0.5>, <0.4, 0.4, 0.6> texture { Clear } hollow }
}
difference { object { Boxes } sphere { <0.3, 0.4, -0.4>, 0.5 texture { Clear } } rotate 20*y translate <-1.8, -0.4, 0> }
difference { object { Boxes } sphere { <0.3, 0.4, -0.4>, 0.5 texture { Clear } hollow } rotate 20*y translate <0.2, -0.4, 0> }
object { Boxes rotate 20*y translate <2.2, -0.4, 0> }
