// A drilled block a million units wide: every length of the scene is 1e6 of what is usual.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = 1e6;
camera { right 4/3*x up y direction 1.4*z rotate <28, -22, 0> translate <2, 3.2, -5>*S }
light_source { <6, 8, -6>*S rgb 1 area_light <2, 0, 0>*S, <0, 0, 2>*S, 5, 5 adaptive 1 }
difference {
  box { -1, 1 }
  cylinder { -2*z, 2*z, .5 }
  cylinder { -2*y, 2*y, .4 }
  pigment { rgb <.8, .5, .3> }
  finish { phong .6 }
  scale S
}
plane { y, -1*S pigment { checker rgb .9 rgb .4 scale S } finish { reflection .2 } }
