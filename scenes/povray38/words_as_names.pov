#version 3.8;
// Words with a number, and members that are called as words are.
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at 0 angle 45 }
light_source { <-4, 6, -6>, 1 }
#declare Set = dictionary { .Prefix: 0.4, .Steps: 9 }
#declare steps = Set.Steps;
#declare Turn = function(i) { tau*i/9 }
#for (I, 0, steps - 1)
    sphere { <2*cos(Turn(I)), 0, 2*sin(Turn(I))>, Set.Prefix pigment { rgb <I/steps, 0.5, 1 - I/steps> } }
#end
#if (version >= 3.8) box { -0.5, 0.5 rotate 20*y pigment { rgb 0.8 } } #end
