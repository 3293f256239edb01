#include "everyday.inc"
#declare rad = 1;
global_settings {
  radiosity { pretrace_start .08 pretrace_end .02 count 60 nearest_count 6 error_bound .6 recursion_limit 2 }
}
camera { location <1.5, 1.7, -3.4> look_at <-.5, 1.1, 1> angle 70 }
light_source { <0, 2.8, 0> rgb <1, .95, .85>*.6 fade_distance 2 fade_power 2 }
difference {
  box { <-3.1, -.1, -4.1>, <3.1, 3.1, 4.1> }
  box { <-3, 0, -4>, <3, 3, 4> }
  box { <2.9, .9, -1>, <3.2, 2.2, 1> }
  pigment { rgb <.9, .85, .75> }
  finish { ambient 0 }
}
box { <-2.9, 0, 2>, <-1, .8, 3.8> pigment { wood scale .1 } finish { ambient 0 } }
#for (i, 0, 8) box {
    <-1+i*.2, 0, 3>, <-.85+i*.2, 1+.5*rand(R), 3.5>
    pigment { rgb <rand(R), rand(R), rand(R)> }
    finish { ambient 0 }
  } #end
sphere { <.2, .5, 1>, .5 pigment { rgb <.8, .1, .1> } finish { ambient 0 phong 1 } }
sky_sphere { pigment { rgb <.6, .7, 1> } }
