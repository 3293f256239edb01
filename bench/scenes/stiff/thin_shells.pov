// Shells a ten-thousandth of their radius thick, one in the other, cut open.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -4> look_at 0 }
light_source { <5, 7, -6> rgb 1 }
#for (I, 1, 6)
  difference {
    sphere { 0, .25*I }
    sphere { 0, .25*I*(1 - 1e-4) }
    plane { <0, -.3, 1>, 0 }
    pigment { rgb <I/6, .5, 1 - I/7> }
    finish { specular .4 }
  }
#end
plane { y, -1.5 pigment { checker rgb .8 rgb .5 } }
