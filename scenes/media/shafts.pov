// Light in the air of a whole scene: cones, a cylinder, a lamp of some size, one that fades; shadows of things in them; lights that air
// dims and lights that it does not see.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -9> look_at <0, 1.6, 0> angle 52 }
media { scattering { 2, rgb .05 extinction .8 } absorption rgb .01 method 3 samples 9 intervals 3 ratio .8 }
light_source { <-4, 6, -1>, rgb <1.4, 1, .5> spotlight point_at <-2, -1, 0> radius 11 falloff 16 tightness 2 media_attenuation on }
light_source { <4.5, 6, 1>, rgb <.5, .8, 1.6> cylinder point_at <2, -1, 0> radius .5 falloff .8 tightness 1 }
light_source { <0, 5.6, 3>, rgb <.7, 1, .7> area_light x*1.2, z*1.2, 2, 2 fade_distance 3 fade_power 2 media_attenuation on }
light_source { <0, 9, -9>, rgb .25 media_interaction off }
light_source { <2, 3, -9>, rgb .15 shadowless }
plane { y, -1 pigment { checker rgb .8 rgb .5 } finish { ambient 0 diffuse .7 } }
plane { -z, -7 pigment { rgb .4 } finish { ambient 0 diffuse .6 } }
union { box { <-3.4, 2.4, -.4>, <-2.6, 2.6, .4> } box { <-2.2, 1.4, -.4>, <-1.6, 1.6, .4> } sphere { <2.9, 2.2, .2>, .35 } torus { 1.2, .2 translate <0, 2.6, 3> }
  pigment { rgb <.8, .5, .4> } finish { ambient 0 diffuse .7 } }
