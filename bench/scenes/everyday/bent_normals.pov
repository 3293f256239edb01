#include "everyday.inc"
Camera_And_Sun(<0, 3, -6>, <0, .5, 0>)
#for (i, -3, 3) sphere {
    <i*1.1, .5, 0>, .5
    pigment { rgb <.8, .5+.06*i, .3> }
    normal {
      #switch (i+3)
        #case (0) quilted 1
          scale .2
          #break
        #case (1) dents .8
          scale .1
          #break
        #case (2) wrinkles .8
          scale .2
          #break
        #case (3) ripples .5 frequency 8
          #break
        #case (4) marble .6 turbulence .4
          scale .2
          #break
        #case (5) bozo 1
          scale .1
          #break
        #case (6) average
          normal_map { [1 bumps 1 scale .1] [1 waves .6 scale .2] }
          #break
      #end
    }
    finish { specular .6 reflection .2 }
  } #end
box { <-4, 0, 2>, <4, 2.5, 2.5> pigment { rgb .7 } normal { brick .6 scale .12 } }
plane { y, 0 pigment { rgb .6 } normal { crackle .6 scale .3 } finish { reflection .15 } }
