// Slopes see the normal that was bent last: in layers, in maps of textures (the upper neighbour is looked at first), in
// averages and without bump scaling.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -12> look_at 0 angle 46 }
light_source { <-20, 30, -40> rgb 1 }
background { rgb <0.2, 0.25, 0.3> }

#declare Steep = color_map { [0.3 rgb <1, 0, 0>] [0.5 rgb <0, 1, 0>] [0.7 rgb <0, 0, 1>] }
#declare Bumpy = texture { pigment { rgb <0.2, 0.6, 0.1> } normal { bumps 1 scale 0.2 } }
#declare Slope = texture { slope { y, 0.3, 0.7 } texture_map { [0.4 Bumpy] [0.6 pigment { rgb <0.8, 0.2, 0.1> }] } }

sphere { <-4.2, 1.7, 0>, 1.3 texture { gradient x texture_map { [0 Slope] [1 Slope] } } }
sphere { <-1.4, 1.7, 0>, 1.3 texture { gradient x texture_map { [0 Bumpy] [1 Slope] } rotate 40*z scale <1, 2, 0.5> } }
sphere { <1.4, 1.7, 0>, 1.3 texture { gradient x texture_map { [0 Slope] [1 Bumpy] } scale 1.7 rotate 20*z } }
sphere { <4.2, 1.7, 0>, 1.3 texture { average texture_map { [1 Bumpy] [1 pigment { aoi color_map { Steep } }] [2 Slope] } } }
sphere { <-4.2, -1.5, 0>, 1.3 texture { pigment { slope y color_map { Steep } } } texture { pigment { rgbt <1, 1, 1, 0.7> } normal { bumps 1 scale 0.3 } } }
sphere { <-1.4, -1.5, 0>, 1.3 texture { pigment { slope y color_map { Steep } } normal { bumps 1 scale <0.2, 0.5, 0.3> no_bump_scale } } }
#declare Steeper = normal { slope y normal_map { [0.25 marble 2 scale 0.3] [0.5 ripples 1 scale 0.2] [0.6 bozo 2 scale 0.3] } scale <0.6, 1, 1.3> }
sphere { <1.4, -1.5, 0>, 1.3 texture { pigment { rgb <0.8, 0.7, 0.6> } normal { gradient x normal_map { [0 Steeper] [1 leopard 2 scale 0.05] } rotate 30 } } }
sphere { <4.2, -1.5, 0>, 1.3 texture { pigment { rgb 1 } normal { density_file df3 "cells.df3", 3 interpolate 1 scale 2.8 translate <2.8, -2.9, -1.6> } finish { phong 0.5 } } }
