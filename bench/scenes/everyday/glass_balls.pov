#include "everyday.inc"
Camera_And_Sun(<0, 3, -7>, <0, .5, 0>)
#for (i, 0, 24) sphere {
    <mod(i, 5)*1.2-2.4, .55+int(i/10)*.9, int(i/5)*1.1-2>, .5
    pigment { rgbf <.95, .98, 1, .95> }
    finish { specular .7 roughness .002 reflection { 0, 1 fresnel } conserve_energy }
    interior { ior 1.5 fade_distance 1 fade_power 1001 fade_color <.3, .8, .5> }
  } #end
plane { y, 0 pigment { checker White Gray30 } }
sky_sphere { pigment { gradient y color_map { [0 White] [1 rgb <.2, .4, .9>] } } }
