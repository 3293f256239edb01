// Media in light groups: the lights that scatter in a ray are those of the object that ends it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -7> look_at <0, .4, 0> angle 46 }
light_source { <-5, 6, -5>, rgb <.5, .5, .6> }
media { scattering { 1, rgb .03 } samples 6 }
plane { y, -1 pigment { checker rgb .7 rgb .4 } finish { ambient 0 diffuse .6 } }
sphere { 0, 40 hollow pigment { rgb <.1, .1, .2> } finish { ambient 0 diffuse 0 emission 1 } no_shadow }
#declare Cloud = sphere { 0, 1 hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { scattering { 2, rgb .9 } density { spherical } } } }
light_group { light_source { <-2, 4, 2>, rgb <1.5, .3, .2> } object { Cloud translate <-1.6, .3, 0> } sphere { <-1.6, .3, .2>, .3 pigment { rgb .8 } } }
light_group { light_source { <2, 4, 2>, rgb <.2, .4, 1.5> } object { Cloud translate <1.6, .3, 0> } box { <.4, -1, 1.2>, <2.8, .2, 1.6> pigment { rgb .8 } } global_lights on }
