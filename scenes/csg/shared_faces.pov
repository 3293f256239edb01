// Boxes that share a face, seen from far off: the points of rays on it are rounded to one side or the other of 0.3 or 0.7, and
// that decides which boxes of a merge, a difference or an intersection show it. At 0.25 they are upon it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-2.8, 3.3, -7.5> look_at <0, 0, 0.5> angle 32 }
light_source { <-5, 10, -20> rgb 1 }
background { rgb <0.2, 0.25, 0.3> }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.5 } }

#macro Red() pigment { rgb <0.9, 0.3, 0.2> } #end
#macro Green() pigment { rgb <0.3, 0.8, 0.3> } #end
#macro Row(Side)
  merge {
    box { <-1.9, -0.9, -Side>, <-1.1, 0.3, 0.5> Red() }
    box { <-1.7, -0.5, -Side>, <-1.3, 0.7, 0.2> Green() }
  }
  difference {
    box { <-0.5, -0.9, -Side>, <0.5, 0.3, 0.5> Red() }
    box { <-0.3, -0.5, -Side>, <0.3, 0.3, 0.2> Green() }
  }
  intersection {
    box { <1.1, -0.9, -Side>, <2.1, 0.3, 0.5> Red() }
    box { <1.3, -0.7, -Side>, <1.9, 0.3, 0.2> Green() }
  }
#end
Row(0.7)
union { Row(0.25) translate <0, 0.013, 2.1> }
