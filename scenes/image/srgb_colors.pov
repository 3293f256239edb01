// Single colours given as srgb in a linear scene.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0, -5> look_at 0 angle 46 }
light_source { <-3, 5, -6> srgb <1, 0.95, 0.9> }
background { srgb <0.3, 0.4, 0.5> }
#for (I, 0, 4)
  sphere { <-1.6 + 0.8*I, 0.5, 0>, 0.37 pigment { srgb <0.8, 0.2*I, 0.3> } }
  sphere { <-1.6 + 0.8*I, -0.5, 0>, 0.37 pigment { srgbt <0.3, 0.2*I, 0.8, 0.5> } }
#end
