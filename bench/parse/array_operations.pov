// More than a million reads and writes of array elements: passes of a bubble sort, sums over a table of two dimensions.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = 500;
#declare A = array[N];
#declare M = array[N][4];
#for (I, 0, N - 1)
  #declare A[I] = mod(I*7919, N);
  #for (J, 0, 3) #declare M[I][J] = I*J; #end
#end
#declare Sum = 0;
#for (Round, 1, 600)
  #for (I, 1, N - 1)
    #if (A[I] < A[I - 1]) #local T = A[I]; #declare A[I] = A[I - 1]; #declare A[I - 1] = T; #end
    #declare Sum = Sum + M[I][mod(Round, 4)];
  #end
#end
#debug concat("sum ", str(Sum, 0, 0), " ", str(A[0], 0, 0), "\n")
sphere { 0, 1 }
