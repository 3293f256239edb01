// The five kinds of scattering, side by side, toward the light, away from it and across; with extinction and eccentricity of both signs.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> look_at 0 right x*12 up y*9 }
light_source { <0, 0, 12>, rgb <1, .55, .3> }
light_source { <-14, 2, 0>, rgb <.3, .5, .9> }
light_source { <3, 9, -14>, rgb .4 }
#macro Slab(N, Kind, Spread, Lost)
  box { <-.9, -1.3, -.5>, <.9, 1.3, .5> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
    interior { media { scattering { Kind, rgb .25 #if (Kind = 5) eccentricity Spread #end extinction Lost } method 2 samples 9 } }
    translate <2*mod(N, 5) - 4 + .6*div(N, 5), 1.8 - 3.4*div(N, 5), 0> }
#end
Slab(0, 1, 0, 1) Slab(1, 2, 0, 1) Slab(2, 3, 0, 1) Slab(3, 4, 0, 1) Slab(4, 5, .6, 1)
Slab(5, 5, -.5, 1) Slab(6, 1, 0, 0) Slab(7, 2, 0, 3) Slab(8, 5, 0, 1)
