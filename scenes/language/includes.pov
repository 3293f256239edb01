// Standard include files: colours, finishes, shapes and textures by name.
#version 3.7;
#include "colors.inc"
#include "textures.inc"
#include "shapes.inc"
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.2, -6> look_at <0, 0.2, 0> angle 50 }
light_source { <-4, 6, -5> color White }
background { color MidnightBlue }

object { UnitBox scale 0.5 pigment { color Orange } finish { Dull } translate <-2, 0, 0> }
sphere { <-0.7, 0, 0>, 0.55 pigment { color BrightGold } finish { Metal } }
object { Cone_Y scale 0.55 pigment { color NeonBlue } finish { Phong_Shiny } translate <0.6, 0, 0> }
object { Disk_Z scale 0.5 texture { Chrome_Texture } translate <1.9, 0, 0> }
plane { y, -0.6 pigment { checker color Gray70, color ForestGreen } }
