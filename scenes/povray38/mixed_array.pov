#version 3.8;
// One array with a solid, a pigment, a number, a vector and a text.
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <5, 6, -6>, 1 }

#declare Parts = array mixed { sphere { 0, 1 }, pigment { checker rgb <0.9, 0.8, 0.3> rgb <0.2, 0.3, 0.7> scale 0.4 }, 0.75, <-1.3, 0, 0>, "x" };
#declare Parts[5] = texture { pigment { rgb <0.3, 0.7, 0.4> } finish { phong 0.6 } }

object { Parts[0] pigment { Parts[1] } scale Parts[2] translate Parts[3] }
box { -Parts[2], Parts[2] texture { Parts[5] } #if (strcmp(Parts[4], "x") = 0) rotate 30*y #end translate -Parts[3] }
