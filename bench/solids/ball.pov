// A ball of radius 1, whose surface a formula tells.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Ball = sphere { 0, 1 }
object { Ball }
