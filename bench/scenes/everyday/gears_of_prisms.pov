#include "everyday.inc"
Camera_And_Sun(<0, 5, -6>, <0, 0, 0>)
#macro Gear(N, Rr) prism {
    linear_sweep linear_spline 0, .3, N*4+1, #for (i, 0, N*4)
      #local a = i*2*pi/(N*4);
      #local q = Rr*(mod(i, 4) < 2 ? 1 : .85); <cos(a)*q, sin(a)*q>, #end
  } #end
#declare G = difference {
  prism {
    linear_spline 0, .3, 97, #for (i, 0, 96)
      #local a = i*2*pi/96;
      #local q = (mod(i, 4) < 2 ? 1 : .85); <cos(a)*q, sin(a)*q>
    #end
  }
  cylinder { -y, y, .3 }
  #for (i, 0, 5)
    cylinder { <.6, -1, 0>, <.6, 1, 0>, .15 rotate i*60*y }
  #end
};
#for (i, -2, 2) #for (k, -1, 2) object {
      G
      rotate <20*i, 10*k, 30*k>
      translate <i*1.9, k*.2, k*1.9>
      pigment { rgb <.8, .6, .3> }
      finish { metallic specular .6 reflection .25 }
    } #end #end
prism {
  bezier_spline 0, .5, 8, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 1>, <-1, 1>, <-1, 0>, <0, 0>
  pigment { Red }
  translate <0, .5, -2>
}
plane { y, -1 pigment { checker White Gray30 } }
