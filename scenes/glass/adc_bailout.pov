// A high adc_bailout drops rays that would add little: weak mirrors lose their second reflection.
#version 3.7;
global_settings { assumed_gamma 1.0 adc_bailout 0.2 max_trace_level 10 }
camera { location <0, 1.6, -5> look_at <0, 0.6, 0> angle 50 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.6, 0.75, 0.9> }

sphere { <-1.2, 0.7, 0>, 0.7 pigment { rgb <0.3, 0.2, 0.1> } finish { reflection 0.35 } }
sphere { <0.3, 0.7, 0.4>, 0.7 pigment { rgb <0.1, 0.2, 0.3> } finish { reflection 0.6 } }
sphere { <1.6, 0.6, -0.3>, 0.6 pigment { rgbf <0.9, 0.9, 0.9, 0.4> } }
plane { y, 0 pigment { checker rgb 0.9, rgb 0.3 } finish { reflection 0.15 } }
