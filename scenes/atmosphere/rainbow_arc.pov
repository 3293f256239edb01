// Part of a rainbow that fades to its ends, turned by its own up; and half a bow with hard ends.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 3, 0> angle 90 }
light_source { <-5, 9, -9>, 1 }
background { rgb <0.25, 0.4, 0.7> }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.5, 0.2> } }
#declare Colors = color_map { [0 rgbt <0.5, 0.1, 1, 0.6>] [0.5 rgbt <0.1, 1, 0.2, 0.5>] [1 rgbt <1, 0.2, 0.1, 0.7>] }
rainbow { direction <0, -0.2, 1> angle 38 width 6 distance 8 arc_angle 140 falloff_angle 50 color_map { Colors } }
rainbow { direction <0.1, 0, 1> up <1, 1, 0> angle 26 width 8 distance 15 arc_angle 100 color_map { Colors } }
