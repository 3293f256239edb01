// A lens makes a cone of light visible in a box of haze; photons stay in the haze and on the floor.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 photons { spacing 0.09 media 40, 1.5 radius 0, 1, 0.25, 0.6 } }
camera { location <0, 2, -6> look_at <0, 1.3, 0> angle 42 }
light_source { <0.5, 9, 0> rgb 1.5 spotlight point_at <0, 0, 0> radius 7 falloff 9 photons { refraction on } }
plane { y, 0 pigment { rgb 0.6 } finish { ambient 0.02 diffuse 0.6 } }
sphere { 0, 0.8 scale <1, 0.6, 1> translate 3.6 * y pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 }
  photons { target refraction on reflection off collect off } }
box { <-1.5, 0.05, -1.5>, <1.5, 2.6, 1.5> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
  interior { media { scattering { 1, rgb <0.25, 0.22, 0.18> extinction 0.5 } method 3 samples 6 } }
  photons { refraction on pass_through collect off } }
