#include "everyday.inc"
Camera_And_Sun(<0, 5, -7>, <0, 0, 0>)
#macro F(a, b) (sin(a*2)*cos(b*2)*.6) #end
union {
  #for (i, -60, 59)
    #for (j, -60, 59)
      #local a = i/20;
      #local b = j/20; smooth_triangle {
        <a, F(a, b), b>, <-1, 2, .1*a>, <a+.05, F(a+.05, b), b>, <-1, 2, .1>, <a, F(a, b+.05), b+.05>, <-1, 2, .2>
        pigment { rgb <abs(F(a, b)), .5, .5> }
      } triangle {
        <a+.05, F(a+.05, b), b>, <a, F(a, b+.05), b+.05>, <a+.05, F(a+.05, b+.05), b+.05>
        pigment { rgb <abs(F(a, b)), .5, .8> }
      }
    #end
  #end
  finish { phong .3 }
}
