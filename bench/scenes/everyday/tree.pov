#include "everyday.inc"
Camera_And_Sun(<0, 3, -8>, <0, 2.5, 0>)
#macro Branch(P, D, L, W, N) #local E = P+D*L; cone { P, W, E, W*.75 } sphere { E, W*.75 }
  #if (N > 0) #for (k, 0, 2) Branch(E, vrotate(vnormalize(D+.6*<rand(R)-.5, rand(R)*.3, rand(R)-.5>*2), 0), L*.78, W*.7,
        N-1) #end #else #for (q, 0, 3) triangle {
        E, E+.2*<rand(R)-.5, rand(R)-.5, rand(R)-.5>, E+.2*<rand(R)-.5, rand(R)-.5, rand(R)-.5>
        pigment { rgb <.2, .6, .1> }
      } #end #end #end
union { Branch(0, y, 1, .12, 6) pigment { rgb <.4, .25, .1> } }
plane { y, 0 pigment { bozo color_map { [0 rgb <.3, .5, .2>] [1 rgb <.2, .4, .1>] } } normal { bumps .5 scale .1 } }
sky_sphere {
  pigment { gradient y color_map { [0 White] [1 rgb <.3, .5, .9>] } }
  pigment { bozo turbulence .6 color_map { [0 rgbt 1] [.6 rgbt 1] [1 rgbt <1, 1, 1, .2>] } scale .4 }
}
