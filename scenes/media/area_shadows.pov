// Light of area lights that has come through media with patterns: every lamp of a grid, only those that adaptive sampling asks, a disc turned to each
// point; through one holder and through one in another.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -7> look_at <0, .2, .4> angle 50 }
light_source { <-5, 8, -2>, rgb .6 area_light 1.5*x, 1.5*z, 3, 3 }
light_source { <5, 7, 1>, rgb <.5, .45, .4> area_light 2*x, 2*y, 5, 5 adaptive 1 }
light_source { <0, 9, 4>, rgb <.2, .25, .3> area_light 2*x, 2*z, 4, 4 circular orient }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse .9 } }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
#declare Cloud = density { wrinkles color_map { [.4 rgb 0] [.7 rgb <.3, .6, 1>] } scale .5 }
sphere { <-1.6, 1.3, .6>, 1 hollow texture { Clear } interior { media { absorption 2 method 3 samples 8 density { Cloud } } } }
sphere { <1.4, 1.3, .4>, 1.1 hollow texture { Clear } interior { media { absorption <.3, .2, .1> density { marble warp { turbulence .6 } scale .4 } } } }
sphere { <1.4, 1.3, .4>, .6 hollow texture { Clear } interior { media { scattering { 1, <.4, .2, .1> extinction 2 } method 2 samples 4 intervals 2 density { Cloud } } } }
cylinder { <0, .1, -1.6>, <0, .5, -1.6>, .5 pigment { checker rgb <.8, .4, .2>, rgbf <.9, .9, .6, .7> scale .3 } finish { ambient 0 diffuse .7 } }
