// A picture with an alpha channel and a background with filter and transmit: seen directly, in a mirror and through glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 45 }
background { rgb <0.3, 0.5, 0.8> filter 0.3 transmit 0.4 }
light_source { <-5, 8, -9> 1 }
sphere { 0, 1 pigment { rgb <1, 0.5, 0.2> } finish { reflection 0.4 } }
sphere { <1.6, 0, 0>, 0.6 pigment { rgb <0.6, 0.9, 0.7> filter 0.6 transmit 0.3 } }
