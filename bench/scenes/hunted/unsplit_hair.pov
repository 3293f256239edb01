// A union of 2,400 discs that is not to be split. POV-Ray has one box about all of them; so had we, and asked each disc as a
// half-space of a CSG tree, a ray at a time. Whole runs at 320x240 on 30 Nov 2026: POV-Ray 7.0 s, Whittle 31.9 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, -.4, 0> angle 43 }
light_source { <-4, 8, -6> rgb <.9, .8, .9> }
plane { y, -1 pigment { checker rgb <.4, .9, .6> rgb <.5, .5, .1> } }
#declare S = seed(58);
union {
  #for (I, 1, 2400)
    #declare A = <-2.2 + 4.4 * rand(S), -.9 + 2.4 * rand(S), -2.2 + 4.4 * rand(S)>;
    disc { A, <-.2 + .4 * rand(S), .1 + .4 * rand(S), -.2 + .4 * rand(S)>, .03 }
  #end
  split_union off
  pigment { rgb <.4, .4, .6> }
  finish { ambient .2 phong .8 reflection .5 }
}
