#include "everyday.inc"
camera { location <0, 1.5, -2.5> look_at <.3, 1, 1> angle 70 } light_source { <0, 2.7, 0> rgb 1 }
global_settings { max_trace_level 20 }
box { <-3, 0, -3>, <3, 3, 3> hollow pigment { checker rgb .9 rgb <.6, .4, .3> scale .75 } finish { reflection .6 } }
sphere { <-.8, .7, 1>, .7 pigment { Silver } finish { reflection .8 metallic } }
cone { <1, 0, .5>, .6, <1, 1.6, .5>, 0 pigment { Red } finish { phong 1 reflection .3 } }
torus { .6, .15 rotate 70*x translate <0, 1.8, 1.5> pigment { Gold } finish { reflection .5 metallic } }
