#include "everyday.inc"
Camera_And_Sun(<0, 2, -6>, <0, 0, 0>)
#local N = 200;
#macro S(i,
    j) #local a = i/N*2*pi; #local b = j/N*pi; #local q = 1.6+.25*sin(5*a)*sin(4*b)+.05*sin(40*b); <q*cos(a)*sin(b),
    q*cos(b), q*sin(a)*sin(b)> #end
mesh {
  #for (i, 0, N-1)
    #for (j, 0, N-1) triangle { S(i, j), S(i+1, j), S(i, j+1) } triangle { S(i+1, j+1), S(i+1, j), S(i, j+1) }
    #end
  #end
  pigment { rgb <.7, .6, .5> }
  finish { specular .3 }
}
plane { y, -2 pigment { rgb .8 } finish { reflection .1 } }
light_source { <-10, 15, -10> rgb .5 area_light 3*x, 3*z, 6, 6 adaptive 1 }
