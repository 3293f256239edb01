#include "everyday.inc"
Camera_And_Sun(<0, 4, -9>, <0, 0, 2>)
height_field {
  function 300, 300 { pattern { wrinkles scale .25 } } smooth
  translate <-.5, -.4, -.5>
  scale <20, 4, 20>
  pigment {
    gradient y
    color_map { [0 rgb <.3, .2, .1>] [.5 rgb <.2, .5, .2>] [1 White] }
    scale 3
    translate -1.5*y turbulence .3
  }
  normal { granite .3 scale .2 }
}
plane {
  y, -.3
  pigment { rgbt <.1, .2, .3, .5> }
  normal { waves .2 frequency 3 scale .7 turbulence .3 }
  finish { reflection { .1, .8 fresnel } specular .8 roughness .003 }
  interior { ior 1.33 }
}
sky_sphere {
  pigment {
    bozo turbulence .7 octaves 6 omega .6
    color_map { [0 White] [.5 rgb <.3, .5, .9>] [1 rgb <.2, .4, .8>] }
    scale <.6, .2, .4>
  }
}
fog { distance 60 rgb .7 }
