// Panes seen almost along their faces: most light is mirrored, and edges of a pixel hold many of them.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 20 }
camera { location <0, .35, -6> look_at <0, .25, 0> angle 30 }
light_source { <5, 9, -4> rgb 1 }
#for (I, 0, 11)
  box {
    <-2, I*.06, -2>, <2, I*.06 + .02, 2>
    pigment { rgbt <.9, .97, .95, .9> }
    finish { reflection { 0, 1 fresnel } conserve_energy }
    interior { ior 1.5 fade_distance 2 fade_power 1 }
  }
#end
sphere { <-.5, 1, 1>, .3 pigment { rgb <.9, .3, .2> } }
plane { y, -.5 pigment { checker rgb .9 rgb .3 scale .5 } }
