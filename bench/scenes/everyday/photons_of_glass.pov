#include "everyday.inc"
global_settings { photons { count 60000 } }
camera { location <0, 4, -6> look_at <0, 0, 0> angle 40 }
light_source { <4, 6, 3> rgb 1.3 photons { reflection on refraction on } }
sphere {
  <0, 1, 0>, 1
  pigment { rgbf 1 }
  finish { reflection { 0, 1 fresnel } ambient 0 diffuse 0 }
  interior { ior 1.5 }
  photons { target reflection on refraction on collect off }
}
torus {
  1.4, .15
  translate .15*y
  pigment { Gold }
  finish { reflection .7 metallic }
  photons { target reflection on }
  translate <-.5, 0, -.5>
}
plane { y, 0 pigment { rgb .8 } }
