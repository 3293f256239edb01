// An area light of 17x17 lamps, all of them asked.
// bench: +W320 +H240 -A
#version 3.7;
#declare Lamp = light_source { <-4, 7, -5> rgb 1 area_light 2.4*x, 2.4*z, 17, 17 }
#include "lit_room.inc"
