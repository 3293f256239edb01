#version 3.8;
// Media of method 3 are sampled to the end of each interval: a glowing ball, a shell that is thin, and a box with smoke in its far half.
global_settings { assumed_gamma 1 }
camera { location <0, 1, -7> look_at 0 angle 50 }
light_source { <-4, 6, -10>, 1 }

plane { y, -1.5 pigment { checker rgb 0.2 rgb 0.5 } }
sphere { <-2, 0, 0>, 1.2 hollow pigment { rgbt 1 }
  interior { media { method 3 samples 5 jitter 0 emission <1, 0.7, 0.3> density { spherical scale 1.2 } } }
}
sphere { <0.3, 0, 0>, 1.1 hollow pigment { rgbt 1 }
  interior { media { method 3 samples 9 jitter 0 aa_level 5 emission 1.5 density { spherical color_map { [0.3 rgb 0] [0.35 rgb <0.2, 1, 0.5>] [0.4 rgb 0] } } } }
}
box { <1.6, -1, -1>, <3.2, 1, 1> hollow pigment { rgbt 1 }
  interior { media { method 3 intervals 2 samples 5 jitter 0 absorption 2 density { gradient z color_map { [0.4 rgb 0] [0.5 rgb 1] } translate -z scale 2 } } }
}
