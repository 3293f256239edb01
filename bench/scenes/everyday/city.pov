#include "everyday.inc"
Camera_And_Sun(<-8, 9, -14>, <0, 0, 0>)
#for (i, -15, 15) #for (k, -15, 15) #local h = .3+2*pow(rand(R), 3); difference {
      box { <i-.35, 0, k-.35>, <i+.35, h, k+.35> }
      box { <i-.3, h-.05, k-.3>, <i+.3, h+1, k+.3> }
      #for (q, 0, 3)
        box { <i-.4, .1+q*.4, k-.2>, <i+.4, .3+q*.4, k-.05> }
      #end
      pigment { rgb <.5+.5*rand(R), .5+.4*rand(R), .6> }
      finish { reflection .05 }
    } #end #end
plane { y, 0 pigment { rgb .3 } }
sky_sphere { pigment { gradient y color_map { [0 White] [1 rgb <.2, .4, .9>] } } }
light_source { <-20, 30, 10> rgb .4 shadowless }
