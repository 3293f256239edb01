// A million numbers read from a file: beside the scene, made by bench/parse_inputs.py.
#version 3.7;
global_settings { assumed_gamma 1 }
#fopen Data "numbers.dat" read
#declare Sum = 0;
#declare Count = 0;
#while (defined(Data))
  #read (Data, A, B, C, D)
  #declare Sum = Sum + A - B + C*D;
  #declare Count = Count + 4;
#end
#debug concat("sum ", str(Sum, 0, 3), " of ", str(Count, 0, 0), "\n")
sphere { 0, 1 }
