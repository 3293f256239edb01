#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.5, 0> }
light_source { <5, 8, -6>, 1 }
#macro Cup(Width, Height)
  cylinder { 0, Height * y, Width pigment { rgb 1 } }
#end
#declare Wide = 1;
#declare High = 2;
#for (I, 1, 3)
  object { Cup(Wide High) translate I * x }  // here
#end
