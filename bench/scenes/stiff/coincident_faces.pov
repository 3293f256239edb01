// Faces of different solids in one plane, inside of a difference and between objects that touch.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 2.2, -4> look_at <0, .2, 0> }
light_source { <4, 6, -5> rgb 1 }
difference {
  box { <-1, 0, -1>, <1, 1, 1> }
  box { <-.5, .5, -1>, <.5, 1, 1> }
  cylinder { <0, 0, -1>, <0, 0, 1>, .4 }
  pigment { rgb <.3, .6, .8> }
}
box { <-.5, .5, -.2>, <.5, .7, .2> pigment { rgb <.9, .4, .2> } }
box { <1, 0, -1>, <1.5, .6, 1> pigment { rgb <.6, .8, .3> } }
plane { y, 0 pigment { rgb .7 } }
