// A pattern that comes after another, of the usual pigment or of a declared one, has nothing of that one's place, waves and turbulence, but its colours.
#version 3.8;
global_settings { assumed_gamma 1 }
#default { pigment { granite scale 0.2 turbulence 0.6 color_map { [0 rgb <0.1, 0.2, 0.6>] [1 rgb <1, 0.9, 0.5>] } } normal { bumps 0.4 scale 0.1 } finish { ambient 0.2 } }
#declare Small = pigment { agate scale 0.1 rotate 30*z frequency 3 sine_wave noise_generator 1 }
camera { location <0, 1, -6> look_at 0 angle 50 }
light_source { <-5, 6, -8>, 1 }
sphere { <-2, 1, 0>, 0.9 pigment { bozo } }
box { <-0.8, 0.2, -0.8>, <0.8, 1.8, 0.8> pigment { Small wood } rotate 20 }
sphere { <2, 1, 0>, 0.9 pigment { Small checker rgb 1, rgb x } normal { dents 0.6 } }
cylinder { <-2, -2, 0>, <-2, -0.4, 0>, 0.9 pigment { Small function { mod(abs(x + y), 1) } } }
sphere { <0, -1.2, 0>, 0.9 pigment { Small image_map { function 64, 64 { pattern { checker scale 0.2 } } } } normal { wrinkles 0.5 } }
sphere { <2, -1.2, 0>, 0.9 pigment { Small scale 3 } }
