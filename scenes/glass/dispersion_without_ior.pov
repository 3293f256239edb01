// `dispersion` without `ior` disperses nothing (left sphere); with `ior 1` it does (right).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -5> look_at 0 angle 50 }
light_source { <-5, 9, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, -1.5 pigment { checker rgb 1, rgb 0.3 } }
sphere { <-1.1, 0, 0>, 1 pigment { rgbt 0.9 } interior { dispersion 1.1 dispersion_samples 8 } }
sphere { <1.1, 0, 0>, 1 pigment { rgbt 0.9 } interior { ior 1 dispersion 1.1 dispersion_samples 8 } }
