// Polynomials of the sixth to the ninth degree, opaque and few: roots by sign changes and the terms of each ray's polynomial.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 1.30 s, Whittle 0.64 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 40 }
light_source { <-5, 8, -9>, 1 }
background { rgb .7 }
#for (I, 0, 5)
  #declare N = 6 + 2*mod(I, 2);
  polynomial {
    N, xyz(N, 0, 0): 1, xyz(0, N, 0): 1, xyz(0, 0, N): 1, xyz(2, 2, 2): -2 + I/3, xyz(3, 1, 0): .5, xyz(0, 1, 4): -.3, xyz(1, 1, 1): .4, xyz(1, 0, 0): -.1, xyz(0, 0, 0): -.4
    sturm
    pigment { rgb <.4 + I/10, .8, .9 - I/10> }
    finish { phong .5 }
    rotate <20*I, 40*I, 0>
    scale .65
    translate <mod(I, 3)*1.7 - 1.7, floor(I/3)*1.6 - .8, 0>
  }
#end
