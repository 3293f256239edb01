// A background that stands before the first #version, or under a version before 3.7, is opaque whatever it says.
background { rgb <0.3, 0.5, 0.8> transmit 0.6 }
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 45 }
light_source { <-5, 8, -9> 1 }
sphere { 0, 1 pigment { rgb <1, 0.5, 0.2> } finish { reflection 0.4 } }
sphere { <1.6, 0, 0>, 0.6 pigment { rgb 1 filter 0.6 transmit 0.3 } }
