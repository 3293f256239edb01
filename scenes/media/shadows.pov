// Light that has come through media: what they absorb and scatter out of it, even where its own flags say that air does not dim it; a lamp
// inside; something opaque inside; a holder that is not hollow dims nothing.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -7> look_at <0, 0, .4> angle 50 }
light_source { <-3, 9, -2>, rgb 1 }
light_source { <3.2, .9, .4>, rgb <.4, .3, .2> }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse .8 } }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
box { <-4, 1, 0>, <-2, 2, 2> hollow texture { Clear } interior { media { absorption rgb <.2, .7, 1.4> } } }
sphere { <-.6, 1.2, .8>, .9 hollow texture { Clear }
  interior { media { absorption rgb <1.5, .8, .4> method 3 samples 12 density { wood turbulence .2 scale .4 } } media { scattering { 1, rgb <.1, .2, .5> } } } }
cylinder { <1.6, .3, .6>, <1.6, 1.8, .6>, .6 hollow texture { Clear } interior { media { absorption 1.2 method 2 samples 4 intervals 3 density { gradient y scale 1.8 } } } }
sphere { <1.6, 1, .6>, .3 pigment { rgb <.9, .5, .2> } finish { ambient 0 diffuse .7 } }
sphere { <3.2, .9, .4>, .7 hollow texture { Clear } interior { media { absorption 2 } } }
box { <-1, .4, -1.8>, <.4, 1, -1> texture { Clear } interior { media { absorption 2 } } }
box { <1, .4, -1.8>, <2.4, 1, -1> hollow pigment { rgbf <1, .6, .3, .9> } finish { ambient 0 diffuse 0 } interior { media { absorption <0, .5, 1> } } }
