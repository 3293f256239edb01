// An area light of 5x5 lamps, all of them asked.
// bench: +W640 +H480 -A
#version 3.7;
#declare Lamp = light_source { <-4, 7, -5> rgb 1 area_light 2.4*x, 2.4*z, 5, 5 }
#include "lit_room.inc"
