#version 3.8;
// Defaults go with the version of the moment: white without ambient light in 3.8, black before it.
global_settings { assumed_gamma 1 }
camera { location -7*z look_at 0 angle 45 }
light_source { <-4, 6, -6>, 1 }

sphere { -2*x, 0.9 }
#version 3.7;
sphere { 0, 0.9 }
sphere { 0, 0.5 pigment { rgb <0.3, 0.9, 0.3> } translate -z }
#version 3.8;
sphere { 2*x, 0.9 }
sphere { 2*x, 0.5 pigment { rgb <0.9, 0.3, 0.3> } translate -z }
