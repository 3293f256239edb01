// Several fogs: constant, on the ground and a coloured one are laid over each other.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <-6, 8, -6>, 1 }
background { rgb <0.2, 0.3, 0.6> }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.7, 0.4, 0.2> } }
#for (I, 0, 5)
  cylinder { 0, 2*y, 0.35 pigment { rgb <0.8, 0.3 + 0.1*I, 0.2> } translate <-2 + 0.9*I, 0, 3*I - 1> }
#end
fog { distance 30 rgbt <0.4, 0.5, 0.9, 0.1> }
fog { distance 3 rgb 0.8 fog_type 2 fog_offset 0.1 fog_alt 0.25 }
fog { distance 25 rgbf <0.9, 0.3, 0.2, 0.7> }
