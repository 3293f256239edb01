// A lamp and small things inside of a ball of radius 1e9.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, .6, 0> }
light_source { <3, 5, -3> rgb 1 area_light x, z, 5, 5 adaptive 1 }
sphere { 0, 1e9 hollow pigment { rgb <.5, .6, .9> } finish { ambient 1 diffuse 0 } }
sphere { <0, .7, 0>, .7 pigment { rgb <.8, .3, .2> } finish { reflection .3 } }
cylinder { -y, 0, 4 pigment { checker rgb .9 rgb .3 scale .5 } }
