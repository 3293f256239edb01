#include "everyday.inc"
Camera_And_Sun(<0, 6, -9>, <0, 0, 0>)
#for (i, 0, 11) light_source {
    <cos(i*pi/6)*5, 5, sin(i*pi/6)*5> rgb <rand(R), rand(R), rand(R)> spotlight point_at <cos(i*pi/6)*2, 0,
      sin(i*pi/6)*2> radius 12 falloff 18 tightness 10 fade_distance 5 fade_power 1
  } #end
#for (i, -5, 5) #for (k, -5, 5) cone { <i*.8, 0, k*.8>, .25, <i*.8, .7, k*.8>, 0 pigment { rgb .9 } } #end #end
plane { y, 0 pigment { rgb .8 } }
