// Smooth triangles whose scales turn a corner's normal against the face: POV-Ray draws only those whose three normals still
// point to one side of it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10 * z right 12 * x up 9 * y look_at 0 }
light_source { <-4, 6, -10> rgb 1 }
background { rgb .1 }
#declare S = seed(94004);
#macro Any() <-1 + 2 * rand(S), -1 + 2 * rand(S), -1 + 2 * rand(S)> #end
#for (I, 0, 11)
  #for (K, 0, 8)
    #local Leaning = <0, 0, -.5> + .9 * Any();
    smooth_triangle {
      <-.5, -.4, 0>, Leaning, <.5, -.3, .1>, <0, 0, -1> + .8 * Any(), <.1, .5, -.1>, <0, 0, -1> + .8 * Any()
      pigment { rgb <.9, .3 + .05 * I, .1 + .08 * K> }
      finish { ambient .3 phong .5 }
      scale .2 + 1.6 * <rand(S), rand(S), rand(S)>
      rotate 25 * Any()
      translate <I - 5.5, K - 4, 0>
    }
  #end
#end
