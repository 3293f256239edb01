#include "everyday.inc"
Camera_And_Sun(<0, 3, -6>, <0, 0, 0>)
#macro P(uu, vv) #local a = uu*2*pi; #local b = vv*2*pi; <(2+0.7*cos(b)+0.1*sin(6*a))*cos(a), 0.7*sin(b)+.1*cos(5*b),
    (2+0.7*cos(b)+0.1*sin(6*a))*sin(a)> #end
#local N = 120;
mesh2 { vertex_vectors { (N+1)*(N+1), #for (i, 0, N) #for (j, 0, N) P(i/N, j/N) #end #end }
  uv_vectors { (N+1)*(N+1), #for (i, 0, N) #for (j, 0, N) <i/N, j/N> #end #end }
  face_indices {
    2*N*N, #for (i, 0, N-1)
      #for (j, 0, N-1) <i*(N+1)+j, i*(N+1)+j+1, (i+1)*(N+1)+j>, <(i+1)*(N+1)+j+1, i*(N+1)+j+1, (i+1)*(N+1)+j>
      #end
    #end
  }
  uv_mapping pigment { checker color White color Red scale 0.05 } finish { phong .8 reflection .2 } }
plane { y, -1.2 pigment { granite } }
