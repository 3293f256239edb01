#include "everyday.inc"
Camera_And_Sun(<0, 4, -7>, <0, 0, 0>)
#include "woods.inc"
#include "stones.inc"
#include "metals.inc"
#for (i, -2, 2) sphere {
    <i*1.4, .6, 0>, .6
    texture {
      #switch (i+2)
        #case (0) T_Stone10
          #break
        #case (1) T_Wood10
          scale .5
          #break
        #case (2) T_Stone24
          #break
        #case (3) T_Chrome_3A
          #break
        #case (4) T_Wood23
          scale .4
          #break
      #end
    }
  }
  box {
    <i*1.4-.5, 0, 1.5>, <i*1.4+.5, 1.3, 2.4>
    texture {
      #switch (i+2)
        #case (0) T_Stone18
          #break
        #case (1) T_Wood1
          scale .5
          #break
        #case (2) T_Stone5
          scale .6
          #break
        #case (3) T_Gold_2C
          #break
        #case (4) T_Wood30
          #break
      #end
    }
  } #end
plane { y, 0 texture { T_Stone30 scale 2 } }
