// A wall of 2400 blocks, each drilled three times, by loops.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <-9, 6, -24> look_at <0, 0.5, 0> angle 44 }
light_source { <-20, 30, -40> rgb 1 }
light_source { <30, 10, -20> rgb 0.3 }
background { rgb <0.6, 0.7, 0.8> }

#declare Block = difference {
  box { <-0.46, -0.21, -0.4>, <0.46, 0.21, 0.4> }
  cylinder { <-0.23, 0, -1>, <-0.23, 0, 1>, 0.13 }
  cylinder { <0.23, 0, -1>, <0.23, 0, 1>, 0.13 }
  cylinder { <-1, 0, 0>, <1, 0, 0>, 0.1 }
}
#for (Row, 0, 39)
  #for (Column, 0, 59)
    object {
      Block
      pigment { rgb <0.75 + 0.2*sin(Row*1.7 + Column), 0.45 + 0.1*cos(Column*2.3), 0.3> }
      translate <Column - 30 + 0.5*mod(Row, 2), Row*0.44 - 8, 2*sin(Column*0.25)>
    }
  #end
#end
plane { y, -8.3 pigment { checker rgb 0.7, rgb 0.5 scale 2 } }
