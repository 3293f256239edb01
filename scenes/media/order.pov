// What comes first of the media of things, those of the whole scene and fog; behind glass, in a mirror, before the sky, and over ground
// fog; rays that are inside of something solid see none of them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -8> look_at <0, .8, 0> angle 48 }
light_source { <-6, 8, -8>, rgb 1 media_attenuation on }
sphere { 0, 40 hollow pigment { rgb <.2, .4, .8> } finish { ambient 0 diffuse 0 emission 1 } no_shadow }
fog { distance 30 rgbft <.8, .6, .5, .2, .1> }
fog { fog_type 2 distance 6 rgb <.9, .9, 1> fog_offset -.8 fog_alt .2 }
media { emission rgb <.012, .02, .006> absorption rgb <.01, .02, .05> density { planar scale 3 } method 3 samples 8 intervals 4 }
plane { y, -1 pigment { checker rgb .8 rgb .3 } finish { ambient 0 diffuse .7 } }
box { <-2.2, -1, 2>, <2.2, 2.6, 2.2> pigment { rgb .1 } finish { ambient 0 diffuse .2 reflection .7 } }
sphere { <-1.8, .4, 0>, .9 hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { scattering { 1, .6 } } } }
sphere { <.3, .2, -1>, .8 pigment { rgbf <.9, 1, .9, .9> } finish { ambient 0 diffuse 0 reflection .1 } interior { ior 1.4 } }
box { <1.4, -.6, -1>, <2.6, 1.2, 0> pigment { rgbt <1, .9, .9, .8> } finish { ambient 0 diffuse .1 } rotate y*12 }
