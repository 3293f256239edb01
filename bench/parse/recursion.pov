// Macros over numbers that call themselves and each other: values, results by reference, sorting, hanoi, ackermann.
#version 3.7;
global_settings { assumed_gamma 1 }

#macro Fib(N)
  #if (N < 2)
    N
  #else
    (Fib(N - 1) + Fib(N - 2))
  #end
#end
#declare Value = (Fib(22));
#debug concat("total fibonacci ", str(Value, 0, 0), "\n")

#declare Moves = 0;
#macro Hanoi(N, From, To, Over)
  #if (N > 0)
    Hanoi(N - 1, From, Over, To)
    #declare Moves = Moves + From * To;
    Hanoi(N - 1, Over, To, From)
  #end
#end
Hanoi(15, 1, 3, 2)
#debug concat("total moves ", str(Moves, 0, 0), "\n")

#macro Divide(Left, Right, Quotient, Rest)
  #local N = 0;
  #local R = Left;
  #while (R >= Right)
    #local R = R - Right;
    #local N = N + 1;
  #end
  #declare Quotient = N;
  #declare Rest = R;
#end
#declare Sum = 0;
#declare Q = 0;
#declare R = 0;
#for (I, 1, 12000)
  Divide(I, 1 + mod(I, 57), Q, R)
  #declare Sum = Sum + Q + R;
#end
#debug concat("total quotients ", str(Sum, 0, 0), "\n")

#declare Count = 12000;
#declare S = seed(3);
#declare List = array[Count];
#for (I, 0, Count - 1) #declare List[I] = floor(rand(S) * 10000); #end
#macro Swap(A, I, J)
  #local Kept = A[I];
  #declare A[I] = A[J];
  #declare A[J] = Kept;
#end
#macro Quick(A, Low, High)
  #if (Low < High)
    #local Pivot = A[floor((Low + High) / 2)];
    #local I = Low;
    #local J = High;
    #while (I <= J)
      #while (A[I] < Pivot) #local I = I + 1; #end
      #while (A[J] > Pivot) #local J = J - 1; #end
      #if (I <= J)
        Swap(A, I, J)
        #local I = I + 1;
        #local J = J - 1;
      #end
    #end
    #local Middle = I;
    Quick(A, Low, J)
    Quick(A, Middle, High)
  #end
#end
Quick(List, 0, Count - 1)
#declare Sum = 0;
#for (I, 0, Count - 1) #declare Sum = Sum + I * List[I]; #end
#debug concat("total sorted ", str(Sum, 0, 0), "\n")

#macro Clamp(V, Low, High) (V < Low ? Low : (V > High ? High : V)) #end
#macro Smooth(T) #local C = Clamp(T, 0, 1); (C * C * (3 - 2 * C)) #end
#declare Sum = 0;
#for (I, 1, 50000) #declare Sum = Sum + Smooth(I / 50000); #end
#debug concat("total smooth ", str(Sum, 0, 3), "\n")

camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 } }
