#include "everyday.inc"
camera { location <1.5, 1.7, -3.4> look_at <-.5, 1.1, 1> angle 70 }
light_source {
  <0, 2.8, 0> rgb <1, .95, .85> area_light .6*x, .6*z, 5, 5 adaptive 1 jitter fade_distance 2 fade_power 2
}
difference {
  box { <-3.1, -.1, -4.1>, <3.1, 3.1, 4.1> }
  box { <-3, 0, -4>, <3, 3, 4> }
  box { <2.9, .9, -1>, <3.2, 2.2, 1> }
  pigment { rgb <.9, .85, .75> }
  normal { bumps .05 scale .02 }
}
box { <-2.9, 0, 2>, <-1, .8, 3.8> pigment { wood scale .1 turbulence .1 } finish { specular .3 reflection .05 } }
#for (i, 0, 8) box { <-1+i*.2, 0, 3>, <-.85+i*.2, 1+.5*rand(R), 3.5> pigment { rgb <rand(R), rand(R), rand(R)> } } #end
cylinder {
  <0, 0, 1>, <0, .75, 1>, .06
  pigment { Gray50 }
  finish { reflection .3 }
} cylinder {
  <0, .75, 1>, <0, .8, 1>, .8
  pigment { rgbf <.9, 1, .95, .8> }
  finish { reflection .2 specular .8 }
  interior { ior 1.5 }
}
sphere { <.2, 1, 1>, .2 pigment { rgb <.8, .1, .1> } finish { phong 1 reflection .2 } }
torus { .3, .08 translate <-.4, .88, .9> pigment { Gold } finish { metallic reflection .4 } }
plane { y, .001 pigment { checker rgb .9 rgb .3 scale .5 } finish { reflection .15 } }
