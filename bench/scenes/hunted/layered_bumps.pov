// Fifteen layers, each with bumps and highlights of its own: normals are bent and lights are asked for every layer and point.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 0.54 s, Whittle 0.32 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 angle 45 }
light_source { <-6, 8, -7>, 1 }
plane {
  z, 0
  texture { pigment { rgb 1 } }
  #for (I, 1, 15)
    texture {
      pigment { bozo scale .1 + .1*mod(I, 5) color_map { [0 rgbt 1] [1 rgbt <.4, .5, .6, .9>] } }
      normal { bumps .3 scale .05*I }
      finish { phong .3 specular .3 }
    }
  #end
}
