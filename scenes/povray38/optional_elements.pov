#version 3.8;
// An array with places left out, and what is asked of them: `defined` and #ifdef.
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at -0.3*y angle 62 }
light_source { <-4, 6, -6>, 1 }
#declare Heights = array[7] optional { 0.6, , 1.2, 0.9, , , 1.5 }
#for (I, 0, 6)
  #if (defined(Heights[I]))
    cylinder { <I - 3, -1, 0>, <I - 3, Heights[I] - 1, 0>, 0.35 pigment { rgb <0.9, 0.3 + 0.1*I, 0.2> } }
  #else
    torus { 0.3, 0.08 translate <I - 3, -0.92, 0> pigment { rgb <0.3, 0.4, 0.8> } }
  #end
#end
plane { y, -1 pigment { rgb 0.7 } }
