// Up to version 3.1 only the bottom layer of a texture filters; the other layers' filter lets all light through.
#version 3.1;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> look_at 0 angle 36 }
light_source { <-20, 30, -40> rgb 1 }
#declare Below = texture { pigment { rgb <1, 0.5, 0.2> } }
#declare Old = texture { Below } texture { pigment { marble turbulence 0.5 color_map { [0 rgbf <1, 0.8, 1, 0.9>] [1 rgbft <0.3, 0.1, 0.6, 0.3, 0.3>] } } }
sphere { <-2.2, 1.2, 0>, 1.1 texture { Old } }
#version 3.7;
sphere { <0.2, 1.2, 0>, 1.1 texture { Old } }
sphere { <2.5, 1.2, 0>, 1.1 texture { Below } texture { pigment { rgbf <0.4, 1, 1, 0.8> } } }
#version 3.1;
sphere { <-2.2, -1.2, 0>, 1.1 texture { Below } texture { pigment { rgbf <0.4, 1, 1, 0.8> } } }
sphere { <0.2, -1.2, 0>, 1.1 texture { Below } texture { pigment { gradient y pigment_map { [0 rgbf <1, 1, 0.5, 0.7>] [1 checker rgbf <0.2, 0.5, 1, 0.6> rgb 1 scale 0.3] } } } }
sphere { <2.5, -1.2, 0>, 1.1 pigment { rgbf <0.5, 0.9, 1, 0.6> } }
plane { -z, -2 pigment { checker rgb 0.9 rgb 0.4 } }
