// double_illuminate: a lamp behind a sheet lights the side that the camera sees; the sheet at the right has none.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 0.6, 0> angle 46 }
light_source { <-2, 5, 6>, 1 }
plane { y, -0.5 pigment { rgb 0.7 } }
#declare Sheet = polygon { 5, <-1, -0.4>, <1, -0.4>, <1, 1.8>, <-1, 1.8>, <-1, -0.4> }
object { Sheet translate -1.3*x pigment { rgb <0.9, 0.8, 0.3> } double_illuminate }
object { Sheet translate 1.3*x pigment { rgb <0.9, 0.8, 0.3> } }
sphere { <-1.3, 0.7, -0.8>, 0.5 pigment { rgb <0.4, 0.6, 0.9> } double_illuminate }
