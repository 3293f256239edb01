// Photons through glass onto a finish with brilliance: a power for each photon around a point, one after the other.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 photons { spacing .03 gather 40, 160 } }
camera { location <-.6, 3.8, -4.7> look_at <0, .4, 0> angle 40 }
light_source { <.3, 6.8, 2.6>, rgb <.9, .8, .9> photons { refraction on reflection on } }
plane { y, 0 pigment { rgb <.9, .85, .8> } finish { ambient .05 diffuse .8 brilliance 2.5 } }
union {
  sphere { <-.9, 1, 0>, .5 }
  sphere { <.7, 1.2, .3>, .5 }
  torus { .5, .16 translate <0, .6, -.9> }
  pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { .05, 1 fresnel } conserve_energy }
  interior { ior 1.5 }
  photons { target refraction on reflection on }
}
