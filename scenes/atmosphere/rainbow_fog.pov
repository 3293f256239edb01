// Two rainbows that cross are averaged, fog lies in front of both; none is seen out of the solid glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 3, 0> angle 90 }
light_source { <-5, 9, -9>, 1 }
background { rgb <0.25, 0.4, 0.7> }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.5, 0.2> } hollow }
sphere { <-2, 3, 0>, 2 pigment { rgbf <0.9, 1, 0.9, 0.9> } interior { ior 1.2 } }
#declare Colors = color_map { [0 rgbt <0.5, 0.1, 1, 0.3>] [0.5 rgbt <0.1, 1, 0.2, 0.2>] [1 rgbt <1, 0.2, 0.1, 0.4>] }
rainbow { direction <0.2, -0.1, 1> angle 32 width 12 distance 20 color_map { Colors } }
rainbow { direction <-0.2, -0.1, 1> angle 32 width 12 distance 40 color_map { Colors } }
fog { distance 25 rgbt <0.8, 0.8, 0.9, 0.2> }
