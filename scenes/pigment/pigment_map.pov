// Pigments within pigments: a map of pigments and a checker of pigments.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2, -5> look_at <0, 0.5, 0> angle 50 }
light_source { <-3, 6, -5> rgb 1 }

#declare Fine = pigment { checker rgb <0.9, 0.9, 0.85>, rgb <0.3, 0.3, 0.35> scale 0.15 }
#declare Bands = pigment { gradient y color_map { [0.5 rgb <0.9, 0.5, 0.3>] [0.5 rgb <0.5, 0.2, 0.3>] } scale 0.2 }
sphere { <-1, 0.8, 0>, 0.8 pigment { gradient x pigment_map { [0.2 Fine] [0.8 Bands] } scale 0.8 translate 0.2*x } }
box { <0.3, 0, -0.5>, <1.5, 1.2, 0.5> pigment { checker pigment { Bands }, pigment { Fine } scale 0.41 translate 0.01 } }
plane { y, 0 texture { checker texture { pigment { rgb 0.8 } }, texture { pigment { Fine scale 2 } } } }
