// An area light of 50x50 lamps, all of them asked.
// bench: +W128 +H96 -A
#version 3.7;
#declare Lamp = light_source { <-4, 7, -5> rgb 1 area_light 2.4*x, 2.4*z, 50, 50 }
#include "lit_room.inc"
