// An area light of 17x17 lamps, adaptive.
// bench: +W640 +H480 -A
#version 3.7;
#declare Lamp = light_source { <-4, 7, -5> rgb 1 area_light 2.4*x, 2.4*z, 17, 17 adaptive 1 }
#include "lit_room.inc"
