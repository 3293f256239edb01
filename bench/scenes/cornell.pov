// A closed box of diffuse walls under an area light, for radiosity beside paths (docs/path_tracing.md).
#version 3.7;
global_settings { assumed_gamma 1 radiosity { } }
camera { location <0, 1, -3.4> look_at <0, 1, 0> angle 40 right x up y }
#default { finish { ambient 0 diffuse 1 } }
#declare White = pigment { rgb .75 }
plane { y, 0 pigment { White } }
plane { -y, -2 pigment { White } }
plane { -z, -1 pigment { White } }
plane { x, -1 pigment { rgb <.75, .25, .25> } }
plane { -x, -1 pigment { rgb <.25, .25, .75> } }
light_source { <0, 1.98, 0> rgb .8 area_light .5*x, .5*z, 9, 9 adaptive 1 area_illumination on fade_distance 1 fade_power 2 }
box { <-.3, 0, -.3>, <.3, 1.2, .3> pigment { White } rotate 18*y translate <-.4, 0, .35> }
box { <-.3, 0, -.3>, <.3, .6, .3> pigment { White } rotate -15*y translate <.4, 0, -.25> }
