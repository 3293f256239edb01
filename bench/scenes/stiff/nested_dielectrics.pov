// Twenty glass balls one in the other, each with an index of its own.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 45 adc_bailout .001 }
camera { location <0, .8, -4> look_at 0 }
light_source { <4, 6, -5> rgb 1 }
#for (I, 1, 20)
  sphere {
    0, I/20
    pigment { rgbt <1, 1 - I*.01, .9 + I*.005, .99> }
    finish { diffuse .02 reflection { 0, 1 fresnel } conserve_energy }
    interior { ior 1.1 + mod(I, 3)*.2 }
  }
#end
plane { y, -1 pigment { checker rgb .9 rgb <.3, .4, .5> } }
