#include "everyday.inc"
Camera_And_Sun(<0, 4, -7>, <0, 0, 0>)
plane {
  y, 0
  pigment { crackle color_map { [0 Black] [.1 rgb <.6, .5, .4>] [1 rgb <.8, .7, .6>] } turbulence .2 scale .7 }
  normal { crackle .6 scale .7 }
  finish { reflection .1 }
}
sphere {
  <0, 1, 0>, 1
  pigment { leopard color_map { [0 Red] [1 Yellow] } scale .1 turbulence .4 }
  normal { wrinkles .6 scale .2 }
}
box {
  <1.5, 0, -.5>, <2.8, 1.5, 1>
  texture {
    brick
    texture { pigment { granite scale .2 } }
    texture { pigment { rgb <.6, .2, .1> } normal { bumps .5 scale .05 } }
    scale .1
  }
}
cone {
  <-2, 0, 0>, .8, <-2, 2, 0>, .1
  pigment { spiral1 5 color_map { [.3 White] [.4 Blue] } rotate 90*x turbulence .1 scale .5 }
}
