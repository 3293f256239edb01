// Unions that POV-Ray keeps whole. Of what coincides in one that is bounded, or not to be split, the last is seen;
// of one that is split the first. Left to right: split, not to be split, bounded, both, one with a part that casts no shadow by itself.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -9> look_at <0, .2, 0> angle 50 }
light_source { <-4, 9, -8> rgb 1 }
plane { y, -1 pigment { rgb .8 } }

#macro Parts(Hidden)
  box { -.6, .6 pigment { rgb <.9, .2, .1> } }
  box { -.6, .6 pigment { rgb <.1, .7, .2> } }
  union {
    sphere { <0, .6, 0>, .45 pigment { rgb <.9, .8, .1> } }
    sphere { <0, .6, 0>, .45 pigment { rgb <.2, .3, .9> } #if (Hidden) no_shadow #end }
  }
  #local I = 0;
  #while (I < 6)
    disc { <.35 * cos(I) , -.2 + .3 * I, .35 * sin(I)>, <.3, 1, .2 * I>, .25 pigment { rgb <.2 * I, .5, .9 - .15 * I> } }
    #local I = I + 1;
  #end
#end

union { Parts(no) translate -3.2 * x }
union { Parts(no) split_union off translate -1.6 * x }
union { Parts(no) bounded_by { sphere { 0, 2.2 } } }
union { Parts(no) split_union off bounded_by { box { -1, <1, 2, 1> } } translate 1.6 * x }
union { Parts(yes) split_union off translate 3.2 * x }
