// Clouds out of a density file between its samples: media and shadows asked for a point at a time, with a division for each of eight samples.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -5> look_at <0, .6, 0> angle 50 }
light_source { <-6, 9, -5>, rgb <1.2, 1.1, 1> }
light_source { <7, 5, -6>, rgb <.3, .35, .5> }
sky_sphere { pigment { gradient y color_map { [0 rgb <.8, .85, .9>] [1 rgb <.25, .4, .75>] } } }
plane { y, -1 pigment { checker rgb .7 rgb .35 } }
#declare Cloud = sphere {
  0, 1 hollow
  pigment { rgbt 1 }
  interior {
    media {
      scattering { 1, 1.4 } intervals 1 samples 6 method 3
      density {
        density_file df3 "cells.df3" interpolate 1 translate -.5 scale 2
        color_map { [0 rgb 0] [.3 rgb .2] [.7 rgb 1] [1 rgb 1.4] }
      }
      density { spherical color_map { [0 rgb 0] [.4 rgb 1] } }
    }
  }
}
#for (I, 0, 3)
  object { Cloud rotate <20*I, 70*I, 0> scale <1, .7, 1> translate <-2 + 1.6*mod(I, 3), .2 + .9*floor(I/3), 1.2*floor(I/3)> }
#end
