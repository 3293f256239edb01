// Two lights and two targets, by a count: a prism spreads white light, an area light shines through a bowl.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 photons { count 4000 gather 10, 50 autostop 0 } }
camera { location <0, 4, -5> look_at <0.2, 0, 0.2> angle 48 }
light_source { <-6, 4, 0> rgb 1 cylinder radius 0.4 falloff 0.5 point_at <-0.8, 0.5, 0> parallel photons { refraction on reflection off } }
light_source { <2, 7, -3> rgb <0.5, 0.5, 0.6> area_light x, z, 2, 2 photons { refraction on reflection on area_light } }
plane { y, 0 pigment { rgb 0.85 } finish { ambient 0.04 diffuse 0.75 } }
prism { -0.8, 0.8, 4, <-0.6, 0>, <0.6, 0>, <0, 1>, <-0.6, 0> rotate -90 * x translate <-0.8, 0.1, 0>
  pigment { rgbt 0.98 } finish { ambient 0 diffuse 0 } interior { ior 1.5 dispersion 1.1 dispersion_samples 5 }
  photons { target 1.5 refraction on collect off } }
difference { sphere { <1.3, 0.7, 0>, 0.7 } sphere { <1.3, 0.9, 0>, 0.6 } plane { -y, -1 translate <0, 0, 0> }
  pigment { rgbt <0.85, 1, 0.9, 0.95> } finish { ambient 0 diffuse 0.05 reflection 0.1 } interior { ior 1.4 }
  photons { target refraction on reflection on collect off } }
