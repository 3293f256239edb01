// A sky of twenty layers of turbulent clouds, most of each of them clear; nothing else is seen.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 0.54 s, Whittle 0.34 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location y look_at <0, 1.6, 4> angle 60 }
light_source { <-6, 8, -7>, 1 }
sky_sphere {
  pigment { gradient y color_map { [0 rgb 1] [1 rgb <.2, .4, .8>] } }
  #for (I, 0, 19)
    pigment {
      bozo
      turbulence .5
      color_map { [0 rgbt 1] [.5 rgbt <1, 1, 1, .9>] [1 rgbt <1, .9 - I/50, .8, .7>] }
      scale .05 + .02*mod(I, 9)
    }
  #end
}
plane { y, 0 pigment { rgb <.3, .4, .2> } }
