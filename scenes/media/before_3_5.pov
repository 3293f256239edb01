// Defaults of language versions before 3.5: ten intervals of one sample. The method is given, since theirs is random.
#version 3.1;
global_settings { assumed_gamma 1 }
camera { location <0, .4, -5> look_at 0 angle 46 }
#declare Old = media { emission rgb <.5, .3, .2> density { spherical } method 2 }
light_source { <5, 6, -4> rgb 1 }
plane { y, -1 pigment { checker rgb .7 rgb .4 } finish { ambient 0 diffuse .6 } }
sphere { 0, 1 hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { Old } } translate -1.1*x }
sphere { 0, 1 hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { scattering { 1, .7 } method 3 density { onion scale .6 } } } translate 1.1*x }
#version 3.7;
sphere { 0, .7 hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { Old } } translate <0, .9, 1> }
media { Old emission .02 }
