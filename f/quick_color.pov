// quick_color takes the place of the pigment at quality 5 and below, and is nothing at higher quality.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 0.4, 0> angle 46 }
light_source { <-3, 5, -6>, 1 }
plane { y, -0.7 pigment { checker rgb 1 rgb 0.2 quick_color rgb <0.5, 0.4, 0.3> } }
sphere { <-1.5, 0, 0>, 0.7 pigment { gradient y scale 0.2 quick_colour rgb <0.9, 0.1, 0.2> } }
box { <-0.5, -0.6, -0.5>, <0.6, 0.5, 0.5> pigment { rgb <0.2, 0.8, 0.3> } }
sphere { <1.9, 0, 0>, 0.7 texture { pigment { rgb 1 quick_color rgb <0.1, 0.3, 0.9> } } }
