// Dynamic programming over arrays of two dimensions: longest common subsequence, knapsack, shortest ways, binomials.
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Length = 500;
#declare S = seed(7);
#declare First = array[Length];
#declare Second = array[Length];
#for (I, 0, Length - 1)
  #declare First[I] = floor(rand(S) * 4);
  #declare Second[I] = floor(rand(S) * 4);
#end
#declare Table = array[Length + 1][Length + 1];
#for (I, 0, Length)
  #for (J, 0, Length)
    #if (I = 0 | J = 0)
      #declare Table[I][J] = 0;
    #else
      #if (First[I - 1] = Second[J - 1])
        #declare Table[I][J] = Table[I - 1][J - 1] + 1;
      #else
        #declare Table[I][J] = max(Table[I - 1][J], Table[I][J - 1]);
      #end
    #end
  #end
#end
#debug concat("total common ", str(Table[Length][Length], 0, 0), "\n")

#declare Things = 150;
#declare Room = 2000;
#declare Best = array[Room + 1];
#for (W, 0, Room) #declare Best[W] = 0; #end
#for (I, 1, Things)
  #declare Weight = 3 + mod(I * 37, 41);
  #declare Worth = 5 + mod(I * 53, 29);
  #declare W = Room;
  #while (W >= Weight)
    #declare Taken = Best[W - Weight] + Worth;
    #if (Taken > Best[W])
      #declare Best[W] = Taken;
    #end
    #declare W = W - 1;
  #end
#end
#debug concat("total worth ", str(Best[Room], 0, 0), "\n")

#declare Towns = 65;
#declare Way = array[Towns][Towns];
#for (I, 0, Towns - 1)
  #for (J, 0, Towns - 1)
    #declare Way[I][J] = (I = J ? 0 : 5 + mod(I * 17 + J * 29, 97));
  #end
#end
#for (K, 0, Towns - 1)
  #for (I, 0, Towns - 1)
    #for (J, 0, Towns - 1)
      #local Through = Way[I][K] + Way[K][J];
      #if (Through < Way[I][J])
        #declare Way[I][J] = Through;
      #end
    #end
  #end
#end
#declare Sum = 0;
#for (I, 0, Towns - 1) #for (J, 0, Towns - 1) #declare Sum = Sum + Way[I][J]; #end #end
#debug concat("total ways ", str(Sum, 0, 0), "\n")

#declare Row = array[61];
#for (N, 0, 60)
  #declare Row[N] = 1;
  #declare K = N - 1;
  #while (K > 0)
    #declare Row[K] = Row[K] + Row[K - 1];
    #declare K = K - 1;
  #end
#end
#debug concat("total binomial ", str(Row[30] / 1e9, 0, 3), "\n")

camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 } }
