// Loops over numbers and one array: a sieve, prime factors, greatest common divisors.
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Most = 300000;
#declare Composite = array[Most + 1];
#declare I = 0;
#while (I <= Most)
  #declare Composite[I] = 0;
  #declare I = I + 1;
#end
#declare Primes = 0;
#declare I = 2;
#while (I <= Most)
  #if (Composite[I] = 0)
    #declare Primes = Primes + 1;
    #declare J = I * I;
    #while (J <= Most)
      #declare Composite[J] = 1;
      #declare J = J + I;
    #end
  #end
  #declare I = I + 1;
#end
#debug concat("total primes ", str(Primes, 0, 0), "\n")

#declare Factors = 0;
#declare N = 2;
#while (N <= 20000)
  #declare Rest = N;
  #declare D = 2;
  #while (D * D <= Rest)
    #while (mod(Rest, D) = 0)
      #declare Rest = Rest / D;
      #declare Factors = Factors + 1;
    #end
    #declare D = D + 1;
  #end
  #if (Rest > 1)
    #declare Factors = Factors + 1;
  #end
  #declare N = N + 1;
#end
#debug concat("total factors ", str(Factors, 0, 0), "\n")

#declare Sum = 0;
#for (A, 1, 350)
  #for (B, 1, 350)
    #local P = A;
    #local Q = B;
    #while (Q > 0)
      #local T = mod(P, Q);
      #local P = Q;
      #local Q = T;
    #end
    #declare Sum = Sum + P;
  #end
#end
#debug concat("total divisors ", str(Sum, 0, 0), "\n")

camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 } }
