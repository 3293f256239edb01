#include "everyday.inc"
Camera_And_Sun(<0, 3, -6>, <0, .6, 0>)
sphere {
  <0, 1, 0>, 1
  pigment { object { text { ttf "timrom.ttf" "ABC" 5, 0 translate <-1, .5, -2.5> } color White color Red } }
}
box {
  <-3, 0, 1>, <-1.4, 1.5, 2>
  pigment { average pigment_map { [1 bozo scale .2] [1 marble turbulence .5 scale .4] } }
}
cylinder {
  <2, 0, 0>, <2, 1.6, 0>, .6
  pigment { function { .5+.5*sin(20*x)*cos(20*y)*sin(10*z) } color_map { [0 Blue] [1 Yellow] } }
}
plane { y, 0 pigment { hexagon White Gray50 Gray20 scale .4 } }
