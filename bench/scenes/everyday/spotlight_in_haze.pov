#include "everyday.inc"
camera { location <0, 1.5, -6> look_at <0, 1, 0> angle 50 }
light_source { <0, 5, 2> rgb 1.5 spotlight point_at <0, 0, 0> radius 15 falloff 20 }
media { scattering { 1, .06 extinction .01 } samples 20 }
#for (i, 0, 8) cylinder {
    <cos(i*.7)*.8, 0, sin(i*.7)*.8>, <cos(i*.7)*.8, 2.2, sin(i*.7)*.8>, .12
    pigment { rgb <.8, .4, .3> }
  } #end
plane { y, 0 pigment { rgb .6 } }
plane { z, 8 pigment { rgb .5 } }
