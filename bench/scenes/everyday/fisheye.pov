#include "everyday.inc"
camera { fisheye location <0, 1, -1> look_at <0, .8, 2> angle 160 } light_source { <3, 8, -4> rgb 1 }
#for (i, -6, 6) #for (k, -6, 6) #if (i*i+k*k > 2) cylinder {
        <i, 0, k>, <i, 1.5, k>, .15
        pigment { rgb <.5+i*.07, .5, .5+k*.07> }
        finish { phong .5 }
      } sphere { <i, 1.6, k>, .2 pigment { rgb .8 } finish { reflection .3 } } #end #end #end
plane { y, 0 pigment { checker White Gray50 } }
sky_sphere { pigment { gradient y color_map { [0 White] [1 Blue] } } }
