// Patterns wrapped around spheres, cylinders and rings, which shine through each other: every point of every layer is mapped.
// Whole runs at 320x240 on 29 Nov 2026: POV-Ray 0.27 s, Whittle 0.22 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 50 }
light_source { <-6, 8, -7>, 1 }
#declare S = seed(4);
#macro Wrapped(Kind)
  pigment {
    checker rgbt <rand(S), rand(S), rand(S), .6>, rgbt <rand(S), rand(S), rand(S), .7>
    scale .06 + .1*rand(S)
    #switch (Kind)
      #case (0) warp { spherical dist_exp .5*rand(S) } #break
      #case (1) warp { cylindrical } #break
      #else warp { toroidal major_radius .7 }
    #end
    rotate 360*<rand(S), rand(S), rand(S)>
  }
#end
#macro Layers(I) #if (I > 0) texture { Wrapped(mod(I, 3)) } Layers(I - 1) #end #end
#for (I, -1, 1) sphere { 0, .8 texture { pigment { rgb .7 } } Layers(36) translate <1.7*I, .2, .4*I> } #end
plane { y, -.7 texture { pigment { rgb .7 } } Layers(36) }
