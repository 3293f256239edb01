// Files that include files, twelve deep, again and again: made by bench/parse_inputs.py.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Total = 0;
#for (Round, 1, 8000)
  #include "deep_1.inc"
#end
#debug concat("total ", str(Total, 0, 0), "\n")
sphere { 0, 1 }
