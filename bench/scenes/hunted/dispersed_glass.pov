// Dispersion of many samples in several glasses: a power for each sample and hit that is no other than that of the hit before.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <0, 2.5, -6> look_at <0, .6, 0> angle 48 }
light_source { <-6, 9, -6>, rgb 1.2 }
sky_sphere { pigment { gradient y color_map { [0 rgb <.9, .85, .8>] [.5 rgb <.3, .45, .8>] } } }
plane { y, -1 pigment { checker rgb .9 rgb .2 scale .4 } }
plane { y, -.2 hollow pigment { rgbf <.9, .95, 1, .7> } finish { reflection { 0, 1 fresnel } conserve_energy } interior { ior 1.33 dispersion 1.06 dispersion_samples 27 } }
#for (I, 0, 4)
  box { -.35, .35 rotate <40, 25*I, 10> translate <-2 + I, .6, .3*mod(I, 2)> pigment { rgbt <.98, .98, 1, .95> }
    interior { ior 1.5 dispersion 1.02 + .02*I dispersion_samples 15 + 3*I } finish { specular .6 } }
#end
