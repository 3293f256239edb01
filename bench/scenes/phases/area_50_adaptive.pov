// An area light of 50x50 lamps, adaptive with jitter.
// bench: +W480 +H360 -A
#version 3.7;
#declare Lamp = light_source { <-4, 7, -5> rgb 1 area_light 2.4*x, 2.4*z, 50, 50 adaptive 2 jitter }
#include "lit_room.inc"
