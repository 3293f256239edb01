// What is clear and what only looks so: holders of media with the default finish, with highlights, with mirrors, with a filter that
// is not quite one, with an index, with fading, around one another and around glass; one is seen in a mirror, one beyond the last level.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 7 }
camera { location <0, 2, -9> look_at <0, .3, 0> angle 48 }
light_source { <-6, 8, -6>, rgb 1 }
light_source { <5, 4, -5>, rgb <.3, .2, .1> area_light x, y, 3, 3 adaptive 1 }
plane { y, -1.3 pigment { checker rgb .8 rgb .4 } finish { ambient 0 diffuse .7 } }
plane { -z, -6 pigment { rgb .3 } finish { ambient 0 reflection .4 } }
#declare Haze = media { scattering { 1, rgb <.25, .3, .35> } samples 4 density { spherical } }
#declare Glow = media { emission rgb <.25, .12, .05> }
sphere { 0, 1.2 hollow pigment { rgbt 1 } interior { media { Haze } } translate <-3.2, 1, 1> }
sphere { 0, 1 hollow pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { media { Glow } } translate <-2.4, -.2, -1.5> }
box { -1, 1 hollow pigment { rgbt 1 } finish { phong .8 } interior { media { Glow } } rotate 30*y translate <-.4, 1.6, 2> }
box { -.8, .8 hollow pigment { rgbf 1 } finish { reflection .15 } interior { media { Glow } } rotate 20*y translate <2.1, 1.8, 1> }
sphere { 0, .8 hollow pigment { rgbt .99 } interior { media { Glow } } translate <3.4, 0, 0> }
union {
    sphere { 0, 1.1 hollow pigment { rgbt 1 } interior { media { Glow } } }
    sphere { 0, .7 pigment { rgbf <.9, 1, .9, .9> } finish { phong .4 } interior { ior 1.5 } }
    sphere { 0, .3 hollow pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 media { absorption rgb <1, .2, .2> } } }
    translate <.3, -.2, -1.8>
}
sphere { 0, .7 hollow pigment { rgbt 1 } interior { ior 1.2 media { Glow } } translate <2.2, -.5, -2> }
cylinder { -y, y, .6 hollow pigment { rgbf 1 } finish { diffuse .9 } interior { fade_distance .8 fade_power 1 media { Glow } } translate <-1, .4, -3.2> scale <1, .7, 1> }
#for (I, 1, 4) sphere { <4.4, 1.4, 0>, I*.2 hollow pigment { rgbt 1 } interior { media { emission <.03, .06, .1> } } } #end
