// A shadowless fill beside a key light; no_shadow on one solid.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -6> look_at <0, 0.4, 0> angle 46 }
light_source { <-4, 6, -4> rgb 0.8 }
light_source { <5, 4, -4> rgb <0.2, 0.25, 0.4> shadowless }

sphere { <-1, 0.7, 0>, 0.7 pigment { rgb <0.9, 0.6, 0.4> } finish { phong 0.6 } }
sphere { <1, 0.7, 0>, 0.7 no_shadow pigment { rgb <0.5, 0.8, 0.5> } finish { phong 0.6 } }
plane { y, 0 pigment { rgb 0.7 } }
