#include "everyday.inc"
global_settings { radiosity { count 100 nearest_count 5 error_bound .5 recursion_limit 1 pretrace_end .02 } }
Camera_And_Sun(<-4, 3, -8>, <0, .8, 0>)
#for (i, -3, 3) #for (k, -2, 3) box {
      <i-.3, 0, k-.3>, <i+.3, .3+rand(R)*1.5, k+.3>
      pigment { rgb <.6+.3*rand(R), .6, .5> }
      finish { ambient 0 }
    } #end #end
sphere { <0, 2, -2>, .6 pigment { rgb .9 } finish { ambient 0 reflection .3 } }
plane { y, 0 pigment { rgb <.5, .6, .4> } finish { ambient 0 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <.9, .9, 1>] [1 rgb <.3, .5, .9>] } } }
