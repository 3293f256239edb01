// Several media in one interior and in interiors within each other: the one with the most intervals says how all are sampled; halvings of
// method 3 that depend on threshold and level.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -6> look_at 0 right x*6 up y*4.5 }
light_source { <4, 6, -8>, rgb .9 }
background { rgb <.5, .6, .7> }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
#declare Shells = density { spherical frequency 2.5 color_map { [0 rgb 0] [.45 rgb 0] [.5 rgb 1] [.62 rgb 1] [.64 rgb 0] [1 rgb 0] } }
sphere { 0, 1 hollow texture { Clear } scale <1, 1.3, 1> translate <-1.7, .6, 0>
  interior {
    media { emission rgb <.9, .4, .1> method 3 samples 5 aa_level 4 aa_threshold .02 density { Shells } }
    media { absorption rgb <.1, .5, 1> intervals 2 method 3 samples 7 aa_level 2 density { gradient x scale 3 translate -1.5*x } }
  } }
sphere { 0, 1 hollow texture { Clear } translate <1, .8, 0>
  interior { media { scattering { 4, rgb .4 } intervals 3 method 2 samples 3 } media { emission rgb <.2, 0, .3> } } }
box { -.7, .7 hollow texture { Clear } rotate <20, 30, 0> translate <1.4, 0, .4>
  interior { media { absorption rgb <.7, .3, .1> density { planar scale .7 } } } }
box { <-2.8, -2.1, -.3>, <2.8, -1, .3> hollow texture { Clear }
  interior { media { emission .8 density { leopard scale .11 } method 3 samples 4 intervals 4 aa_level 5 aa_threshold .05 } media { scattering { 5, .3 eccentricity .4 } } } }
