#version 3.8;
// `version` is a number in expressions and comes back after an older part; tau is a turn, in functions too.
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at 0 angle 42 }
light_source { <-4, 6, -6>, 1 }
#declare Before = version;
#version 3.7;
#declare Count = (version < 3.75 ? 9 : 5);
#version Before;
#declare Wave = function(T) { 0.3*sin(3*tau*T) }
#for (I, 0, Count - 1)
  sphere { <1.8*cos(tau*I/Count), Wave(I/Count + 0.03), 1.8*sin(tau*I/Count)>, 0.25*version/3.8 pigment { rgb <I/Count, 0.6, 1 - I/Count> } }
#end
cylinder { -y, y*(version - 3.3), 0.3 }
