// Splines asked in loops: a path of four kinds, and beads along it.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Path(Kind)
  spline {
    #switch (Kind) #case (0) linear_spline #break #case (1) quadratic_spline #break #case (2) cubic_spline #break
    #else natural_spline #end
    #for (P, -1, 101) P/100, <10*sin(P/9), 3*cos(P/5), P/10> #end
  }
#end
#declare Sum = 0;
#for (K, 0, 3)
  #declare S = Path(K)
  #for (I, 0, 99999)
    #declare At = S(I/100000);
    #declare Sum = Sum + At.x + At.y*2 + vlength(S(1 - I/100000));
    #if (mod(I, 50) = 0) sphere { At, 0.05 pigment { rgb <K/3, 1, 0> } } #end
  #end
#end
#debug concat("sum ", str(Sum, 0, 3), "\n")
camera { location <0, 10, -30> look_at 0 }
light_source { <100, 200, -200>, rgb 1 }
