// A gear: teeth in a loop, united, then drilled.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -4> look_at <0, 0, 0> angle 40 }
light_source { <4, 6, -3> rgb 1 }
background { rgb <0.1, 0.12, 0.15> }

#declare Teeth = 18;
difference {
  union {
    cylinder { -0.2*y, 0.2*y, 1.2 }
    #declare I = 0;
    #while (I < Teeth)
      box { <1.1, -0.2, -0.1>, <1.45, 0.2, 0.1> rotate 360*I/Teeth*y }
      #declare I = I + 1;
    #end
  }
  cylinder { -y, y, 0.3 }
  #for (I, 0, 4)
    cylinder { <0.75, -1, 0>, <0.75, 1, 0>, 0.22 rotate 72*I*y }
  #end
  torus { 1.0, 0.07 translate 0.2*y pigment { rgb <0.3, 0.25, 0.2> } }
  pigment { rgb <0.8, 0.7, 0.45> }
  finish { phong 0.7 metallic }
}
