// A camera that stands inside of glass, water and a sky: what it is in is what POV-Ray's hierarchy of boxes finds last, not what is declared last.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <-.5, .5, -4.3> look_at <0, -.2, .3> angle 60 }
light_source { <2, 5, -6>, rgb 1 }
plane { y, -1.2 pigment { checker rgb <1, .6, .2>, rgb <.3, .2, .6> } finish { ambient .3 } }
box { <-7.1, -1.15, -7.6>, <7.2, 7.6, 7.1> pigment { rgbf 1 } finish { diffuse 0 } interior { ior 1.33 } hollow }
sphere { <-1.5, .2, -2>, 3.4 pigment { rgbf <.9, 1, .9, 1> } finish { diffuse 0 } interior { ior 1.5 } }
sphere { <1, 0, 2>, .8 pigment { rgb <.9, .3, .2> } finish { phong .5 } }
sphere { 0, 40 pigment { gradient y color_map { [0 rgb <.6, .2, .4>] [1 rgb <.3, .5, .9>] } scale 12 } finish { ambient 1 diffuse 0 } hollow }
