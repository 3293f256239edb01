#include "everyday.inc"
Camera_And_Sun(<2.5, 1.5, -6>, <2.3, .4, 0>)
text {
  ttf "timrom.ttf" "Whittle" .4, 0
  pigment { rgb <.8, .2, .1> }
  normal { bumps .3 scale .05 }
  finish { specular .6 reflection .15 }
  scale 1.5
}
text {
  ttf "cyrvetic.ttf" "POV-Ray 3.7" .2, 0
  pigment { Gold }
  finish { metallic phong 1 reflection .3 }
  translate <0, -1, 0>
}
plane { y, -1.1 pigment { wood turbulence .2 scale .3 } normal { bumps .2 scale .1 } finish { reflection .2 } }
light_source { <-10, 10, -20> rgb .5 }
