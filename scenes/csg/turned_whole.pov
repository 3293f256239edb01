// A CSG object that is turned inside out as a whole keeps the box that it had before: planes that go on outside of its clip or of what they cut end there.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 0.6, -9> look_at 0 angle 40 }
light_source { <-5, 9, -8> rgb 1 shadowless }
background { rgb <0.3, 0.5, 0.8> }
#default { finish { ambient 0.5 diffuse 0.5 } }
difference {
  union { sphere { 0, 0.8 } plane { <0.7, -0.1, -0.9>, 0.2 } clipped_by { box { -0.6, 0.7 } } }
  plane { <0.5, -0.7, -0.6>, 0.1 }
  pigment { rgb <0.9, 0.6, 0.3> } inverse translate -1.6*x
}
difference {
  box { -1, 1 }
  plane { <0.5, -0.7, -0.6>, -0.2 clipped_by { sphere { 0, 2 } } }
  pigment { rgb <0.4, 0.8, 0.5> } inverse rotate 30*y translate 1.6*x
}
