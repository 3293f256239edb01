// Nine isosurfaces of functions that libraries and scenes are full of: powers, sines, seams of angles, bells.
// bench: +W320 +H240 -A
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

camera { location <0, 6.5, -7.5> look_at <0, 0, -.3> angle 40 }
light_source { <5, 9, -6>, .9 }
light_source { <-6, 5, -3>, .3 shadowless }
background { rgb <.6, .7, .8> }
plane { y, -1 pigment { checker rgb .8 rgb .55 scale .7 } }

#macro Shown(Of, Steepest, At, Color)
  isosurface {
    function { Of(x, y, z) }
    contained_by { box { -1, 1 } }
    max_gradient Steepest accuracy .001
    pigment { Color }
    finish { specular .3 roughness .03 }
    scale .95
    translate At
  }
#end

#declare Gyroid = function { abs(sin(4*x)*cos(4*y) + sin(4*y)*cos(4*z) + sin(4*z)*cos(4*x)) - .4 }
#declare Power = function(x, y, z, e) { pow(pow(abs(x), e) + pow(abs(y), e) + pow(abs(z), e), 1/e) - .8 }
#declare Cushion = function { Power(x, y, z, 3) }
#declare Ring = function { pow(pow(abs(pow(x*x + z*z, .5) - .65), 4) + pow(abs(y), 4), .25) - .25 }
#declare Helix = function { f_helix1(x, y, z, 2, 8, .14, .6, 1, .4, 0) }
#declare Weave = function { f_mesh1(x, y, z, .4, .4, 1, .06, 1) - .04 }
#declare Spikes = function { f_spikes_2d(x, y + .4, z, .9, 6, 6, 2) }
#declare Comma = function { f_comma(x, y, z, .8) }
#declare Drops = function { .9 - .12/(pow(x - .4, 2) + y*y + z*z + .05) - .2/(pow(x + .3, 2) + y*y + z*z + .05) }
#declare Bells = function { f_cross_ellipsoids(x, y, z, .2, 3, 1, .5) }

Shown(Gyroid, 14, <-2.2, 0, 2.2>, rgb <.9, .5, .3>)
Shown(Cushion, 2, <0, 0, 2.2>, rgb <.4, .7, .4>)
Shown(Ring, 3, <2.2, 0, 2.2>, rgb <.4, .5, .9>)
Shown(Helix, 3, <-2.2, 0, 0>, rgb <.9, .8, .3>)
Shown(Weave, 2, <0, 0, 0>, rgb <.8, .4, .6>)
Shown(Spikes, 8, <2.2, 0, 0>, rgb <.4, .8, .8>)
Shown(Comma, 2, <-2.2, 0, -2.2>, rgb <.7, .6, .9>)
Shown(Drops, 12, <0, 0, -2.2>, rgb <.9, .9, .9>)
Shown(Bells, 5, <2.2, 0, -2.2>, rgb <.6, .9, .5>)
