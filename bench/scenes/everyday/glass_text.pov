#include "everyday.inc"
Camera_And_Sun(<2, 1.2, -6>, <1.9, .5, 0>)
text {
  ttf "timrom.ttf" "GLASS" .5, 0
  scale 1.4
  pigment { rgbf <.9, 1, .95, .9> }
  finish { specular .8 reflection { .02, .9 fresnel } conserve_energy }
  interior { ior 1.5 fade_distance 1 fade_power 2 fade_color <.5, .9, .7> }
}
plane { y, -.02 pigment { checker rgb .9 rgb <.4, .5, .7> scale .5 } }
sky_sphere { pigment { gradient y color_map { [0 White] [1 rgb <.3, .5, .9>] } } }
