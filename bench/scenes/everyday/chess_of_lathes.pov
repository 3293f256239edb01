#include "everyday.inc"
Camera_And_Sun(<0, 5, -9>, <0, .3, 0>)
#declare Pawn = lathe {
  bezier_spline 16, <0, 0>, <.3, 0>, <.42, .02>, <.42, .1>, <.42, .1>, <.42, .2>, <.2, .25>, <.15, .5>, <.15, .5>,
  <.13, .65>, <.2, .68>, <.22, .7>, <.22, .7>, <.3, .85>, <.2, 1>, <0, 1>
};
#for (i, -4, 3) #for (k, -4, 3) #if (mod(i+k+20, 3) < 2) object {
        Pawn
        translate <i+.5, 0, k+.5>
        texture {
          #if (mod(i, 2) = 0)
            pigment { wood turbulence .1 scale .15 }
            finish { specular .6 reflection .1 }
          #else
            pigment { marble turbulence .5 scale .3 }
            finish { phong .8 reflection .15 }
          #end
        }
      } #end #end #end
box { <-4.2, -.2, -4.2>, <4.2, 0, 4.2> pigment { checker rgb .9 rgb <.2, .1, .05> } finish { reflection .2 } }
light_source { <-15, 20, -5> rgb .5 }
