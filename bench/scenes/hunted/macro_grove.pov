// Trees by a recursive macro, 20,000 cones and spheres: reading and plan, and of these most was the first touch of small pages of memory.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3.5, -11> look_at <0, 3.2, 0> angle 50 }
light_source { <-30, 60, -40>, rgb 1.1 }
background { rgb <.6, .75, .95> }
#declare R = seed(21);
#declare Bark = texture { pigment { wood turbulence .3 color_map { [0 rgb <.25, .17, .1>] [.6 rgb <.4, .3, .2>] [1 rgb <.15, .1, .07>] } scale .1 } }
#declare Leaf = texture { pigment { spotted color_map { [0 rgb <.1, .4, .05>] [1 rgb <.4, .6, .1>] } scale .5 } finish { specular .2 } }
#macro Branch(P, D, L, W, N)
  #local Q = P + D*L;
  cone { P, W, Q, .7*W texture { Bark } }
  sphere { Q, .72*W texture { Bark } }
  #if (N > 0)
    #for (K, 1, 3)
      #local T = 20 + 25*rand(R);
      #local E = vnormalize(vrotate(vrotate(D, <3*T*(rand(R) - .5), 0, 3*T*(rand(R) - .5)>), 120*rand(R)*y) + .2*y);
      Branch(Q, E, L*(.65 + .2*rand(R)), .62*W, N - 1)
    #end
  #else
    #for (K, 1, 6)
      sphere { 0, .09 scale <1, .25, .5> rotate 360*<rand(R), rand(R), rand(R)> translate Q + .35*(<rand(R), rand(R), rand(R)> - .5) texture { Leaf } }
    #end
  #end
#end
#declare Tree = union { Branch(0, y, 1.7, .22, 6) }
object { Tree }
object { Tree scale .8 rotate 77*y translate <-4, 0, 4> }
object { Tree scale .9 rotate 187*y translate <4.5, 0, 6> }
plane { y, 0 pigment { rgb <.3, .4, .2> } }
