#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6>, 1 }
#declare I = 0;
#declare J = 0;
#if (I)
  #while (J < 3)  // here
    sphere { J*x, 1 pigment { rgb 1 } }
    #declare I = I + 1;
  #end
#end
box { 0, 1 pigment { rgb J } }
