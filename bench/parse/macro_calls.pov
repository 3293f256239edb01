// A million macro calls: parameters by reference and by value, locals, results inside expressions.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Clamp(V, Low, High) #local W = max(V, Low); min(W, High) #end
#macro Mix(A, B, F) (A*(1 - F) + B*F) #end
#macro Step(Sum, K)
  #if (mod(K, 3) = 0) #declare Sum = Sum + Mix(K, 2*K, 0.25); #else #declare Sum = Sum + Clamp(K*0.5, 1, 1000); #end
#end
#declare Total = 0;
#declare K = 0;
#while (K < 500000)
  Step(Total, K)
  #declare K = K + 1;
#end
#debug concat("total ", str(Total, 0, 3), "\n")
sphere { 0, 1 }
