#version 3.8;
// Media of method 3: each gap between samples dims its own light. Glowing smoke, lit smoke, and smoke that is even.
global_settings { assumed_gamma 1 }
camera { location <0, 1, -7> look_at 0 angle 50 }
light_source { <-4, 6, -10>, 1 }
plane { y, -1.5 pigment { checker rgb 0.2 rgb 0.5 } finish { ambient 0.1 diffuse 0.7 } }
sphere { <-2, 0, 0>, 1.2 hollow pigment { rgbt 1 }
  interior { media { method 3 samples 4 jitter 0 emission <1, 0.7, 0.3> absorption <0.5, 1, 3> density { spherical scale 1.2 } } }
}
sphere { <0.5, 0, 0>, 1.1 hollow pigment { rgbt 1 } interior { media { method 3 samples 5 jitter 0 scattering { 1, rgb <0.8, 0.6, 0.4> } } } }
box { <1.8, -1, -1>, <3.2, 1, 1> hollow pigment { rgbt 1 }
  interior { media { method 3 intervals 2 samples 4 jitter 0 emission 0.8 absorption <2, 1, 0.5> } }
}
