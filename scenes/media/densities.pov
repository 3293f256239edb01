// Densities: a map of colours, patterns with turbulence and warps, a product of two, a factor above 1, moved in three ways.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.4, -7> look_at <0, .3, 0> angle 42 }
light_source { <-5, 8, -6>, rgb 1 }
background { rgb <.05, .08, .16> }
plane { y, -1 pigment { checker rgb .5 rgb .3 } finish { ambient 0 diffuse .6 } }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
sphere {
  0, 1 hollow texture { Clear }
  interior { media { emission rgb <1.4, .9, .4> absorption rgb .6
    density { spherical color_map { [0 rgb 0] [.3 rgb <0, .2, .9>] [.7 rgb <1, .4, .1>] [1 rgb 1.5] } } } }
  translate <-2.3, .1, 0>
}
box {
  -.9, .9 hollow texture { Clear }
  interior { media { scattering { 1, rgb 1.4 } method 3 samples 14
    density { bozo turbulence .6 color_map { [0 rgb 0] [.45 rgb 0] [.75 rgb <1, .9, .7>] [1 rgb 1.2] } scale .5 }
    density { boxed scale .9 color_map { [0 rgb 0] [.35 rgb 1] } } } }
  rotate y*35 translate <0, 0, .8>
}
cylinder {
  -y, y, .8 hollow texture { Clear }
  interior { media { emission rgb <.3, .9, .5> absorption <.9, .2, .6> method 2 samples 24
    density { gradient y triangle_wave warp { black_hole <.3, .4, 0>, .7 strength 1.3 } scale .7 }
    rotate z*30 } }
  translate <2.2, .1, 0>
}
