// Layers that are wholly clear in places: without highlights no lamp matters there, with them it does; two layers, a mirror, a bent
// normal, light from behind, an area light.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1.5, -8> look_at <0, .5, 0> angle 46 }
light_source { <-5, 7, -6>, rgb .8 area_light 2*x, 2*y, 3, 3 adaptive 1 }
light_source { <6, 3, -2>, rgb <.2, .3, .4> }
background { rgb <.2, .3, .5> }
plane { y, -1 pigment { checker rgb .9 rgb .4 } }
#declare Holes = pigment { leopard color_map { [0 rgbt 1] [.4 rgbt 1] [.4 rgb <.3, .7, .2>] [1 rgb <.1, .4, .1>] } scale .12 }
#declare Stripes = pigment { gradient x color_map { [.5 rgbf 1] [.5 rgb <.8, .3, .2>] } scale .4 }
sphere { <-3, 0, 0>, 1 pigment { Holes } }
sphere { <-1, 0, 0>, .9 pigment { Holes } finish { phong .9 phong_size 20 } hollow interior { ior 1.1 } }
sphere { <1, 0, 0>, .9 pigment { Holes } finish { specular .6 reflection .2 } }
sphere { <3, 0, 0>, 1 texture { pigment { Holes } } texture { pigment { Stripes } finish { diffuse .8 } } }
disc { <-2, 2.2, 1>, <.2, .3, -1>, .9 pigment { Stripes } finish { diffuse .4, .5 } }
disc { <0, 2.2, 1>, <-.2, .2, -1>, .9 pigment { Stripes } normal { bumps .6 scale .1 } }
disc { <2, 2.2, 1>, <-.4, .3, -1>, .9 pigment { Stripes } finish { irid { .4 thickness .6 } } }
cylinder { <0, -.9, -3>, <0, -.4, -3>, .5 open pigment { image_pattern { function 8, 8 { select(.5 - abs(mod(8*x, 2) - 1), 0, 1) } } color_map { [.5 rgbt 1] [.5 rgb <.9, .8, .2>] } warp { cylindrical } } double_illuminate }
