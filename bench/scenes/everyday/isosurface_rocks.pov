#include "everyday.inc"
Camera_And_Sun(<0, 2, -5>, <0, 0, 0>)
isosurface {
  function {
    f_sphere(x, y, z, 1.3) - f_noise3d(x*3, y*3, z*3)*.5 - f_noise3d(x*12, y*12, z*12)*.08
  } contained_by { sphere { 0, 1.6 } } max_gradient 3
  pigment { granite color_map { [0 rgb .2] [1 rgb .8] } scale .5 }
  finish { specular .2 }
}
isosurface {
  function {
    f_rounded_box(x, y, z, .1, .5, .5, .5)+.03*sin(x*20)*sin(y*20)*sin(z*20)
  } contained_by { box { -.7, .7 } } max_gradient 2
  pigment { Tan }
  translate <2, -.3, 0>
}
plane { y, -1.2 pigment { checker White Gray30 } }
