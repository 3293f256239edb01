#include "everyday.inc"
Camera_And_Sun(<0, 2, -5>, <0, .5, 0>)
#declare fn = function { pattern { granite scale 2 } }
isosurface {
  function { f_torus(x, y, z, 1, .35) + .06*sin(atan2(z, x)*24) } contained_by { box { -1.6, 1.6 } } max_gradient 2.2
  translate .6*y
  pigment { Gold }
  finish { metallic reflection .2 specular .6 }
}
isosurface {
  function { x*x+y*y+z*z-1-.2*sin(8*x)*sin(8*y)*sin(8*z) } contained_by { sphere { 0, 1.25 } } max_gradient 4
  scale .6
  translate <1.8, .6, -.6>
  pigment { rgb <.3, .6, .8> }
  finish { phong .8 }
}
isosurface {
  function { y-.25*fn(x, 0, z) } contained_by { box { <-5, -.3, -5>, <5, .5, 5> } } max_gradient 1.6
  pigment { rgb <.6, .5, .4> }
}
