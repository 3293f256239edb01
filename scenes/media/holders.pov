// What holds media: hollow and solid things, a union whose parts share an interior, a merge, parts with interiors of their own, an
// opaque thing inside, a clear one that is solid inside; seen from inside of a holder that has no end.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -8> look_at 0 right x*9 up y*6.75 }
light_source { <3, 6, -9>, rgb .7 }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
#declare Glow = interior { media { emission rgb <.35, .2, .1> } }
plane { -z, -6 pigment { checker rgb .3 rgb .15 scale .5 } finish { ambient 0 diffuse 1 } }
plane { -x, 30 hollow texture { Clear } interior { media { absorption rgb <.02, .01, .03> } } }
#macro Two() box { <-.9, -.6, -1>, <.3, .6, 1> } box { <-.3, -.4, -1>, <.9, .8, 1> } #end
union { Two() hollow texture { Clear } interior { Glow } translate <-3, 2, 0> }
merge { Two() hollow texture { Clear } interior { Glow } translate <0, 2, 0> }
union { box { <-.9, -.6, -1>, <.3, .6, 1> interior { Glow } } box { <-.3, -.4, -1>, <.9, .8, 1> interior { Glow } } hollow texture { Clear } translate <3, 2, 0> }
box { -.8, .8 texture { Clear } interior { Glow } translate <-3, 0, 0> }
difference { box { -.8, .8 } sphere { 0, .7 } hollow texture { Clear } interior { Glow } translate <-1, 0, 0> }
box { -.8, .8 hollow texture { Clear } interior { Glow } translate <1, 0, 0> }
sphere { <1, 0, 0>, .4 pigment { rgb <.2, .6, .9> } finish { ambient 0 diffuse .8 } }
box { -.8, .8 hollow texture { Clear } interior { Glow } translate <3, 0, 0> }
sphere { <3, 0, 0>, .5 texture { Clear } }
sphere { 0, .9 hollow pigment { rgbf <1, .9, .8, .9> } finish { ambient 0 diffuse 0 reflection .1 } interior { ior 1.3 media { emission <.1, .3, .2> } } translate <-2, -2.2, 0> }
sphere { 0, .9 hollow texture { Clear } interior { media { absorption -.3 } } translate <2, -2.2, 0> }
