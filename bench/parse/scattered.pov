// Objects in loops full of arithmetic: numbers are the most of the text, a small sphere now and then.
#version 3.7;
global_settings { assumed_gamma 1 }

#declare S = seed(12);
#declare Kept = array[700];
#declare Count = 0;
#declare Tries = 0;
#while (Count < 700)
  #local P = <rand(S), rand(S), rand(S)>;
  #local Near = 10;
  #local I = 0;
  #while (I < Count)
    #local D = vlength(P - Kept[I]);
    #if (D < Near)
      #local Near = D;
    #end
    #local I = I + 1;
  #end
  #declare Tries = Tries + 1;
  #if (Near > 0.07)
    #declare Kept[Count] = P;
    #declare Count = Count + 1;
    sphere { P, 0.045 pigment { rgb P } finish { ambient 1 } }
  #end
#end
#debug concat("total tries ", str(Tries, 0, 0), "\n")

union {
  #declare I = 0;
  #while (I < 20000)
    #local A = radians(mod(I * 137.508, 360));
    #local R = sqrt(I / 20000);
    #local Steps = 0;
    #local V = R;
    #while (V > 0.01 & Steps < 20)
      #local V = V * 0.7;
      #local Steps = Steps + 1;
    #end
    sphere { <R * cos(A), R * sin(A), 2 + V>, 0.01 + 0.0004 * Steps }
    #declare I = I + 1;
  #end
  pigment { rgb 1 }
}
#debug concat("total steps ", str(I, 0, 0), "\n")
camera { location -5*z look_at 0 }
