// A closed box of diffuse walls and a ball of glass under an area light: radiosity and photons beside paths
// (docs/path_tracing.md).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 radiosity { } photons { spacing .01 } }
camera { location <0, 1, -3.4> look_at <0, 1, 0> angle 40 right x up y }
#default { finish { ambient 0 diffuse 1 } }
#declare White = pigment { rgb .75 }
plane { y, 0 pigment { White } }
plane { -y, -2 pigment { White } }
plane { -z, -1 pigment { White } }
plane { x, -1 pigment { rgb <.75, .25, .25> } }
plane { -x, -1 pigment { rgb <.25, .25, .75> } }
light_source {
  <0, 1.98, 0> rgb .8 area_light .5*x, .5*z, 9, 9 adaptive 1 area_illumination on fade_distance 1 fade_power 2
  photons { area_light reflection on refraction on }
}
box { <-.3, 0, -.3>, <.3, 1.2, .3> pigment { White } rotate 18*y translate <-.4, 0, .35> }
sphere { <.4, .42, -.25>, .4
  pigment { rgbt 1 } finish { diffuse 0 reflection { 0, 1 fresnel on } conserve_energy } interior { ior 1.5 }
  photons { target reflection on refraction on }
}
