// Wax under a glass ball that light comes through as photons, in mist that light shines through.
#version 3.7;
global_settings {
  assumed_gamma 1 mm_per_unit 10
  photons { spacing 0.05 }
  subsurface { samples 100, 50 }
}
camera { location <0, 3, -7> look_at <0, 0.8, 0> angle 40 }
light_source { <0, 9, -1>, 1 photons { refraction on reflection off } }
background { rgb 0.1 }
plane { y, 0 pigment { rgb <0.5, 0.6, 0.7> } finish { ambient 0 diffuse 0.8 } }
box {
  <-1.6, 0, -1.2>, <1.6, 0.8, 1.2> pigment { rgb <0.9, 0.7, 0.4> }
  finish { ambient 0 diffuse 0.9 subsurface { translucency <1.2, 0.7, 0.4> } } interior { ior 1.4 }
}
sphere { <0, 2.1, -0.2>, 0.8 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } photons { target refraction on collect off } }
sphere { <-2.3, 1.2, 0>, 1 pigment { rgbt 1 } hollow interior { media { scattering { 1, 0.3 } method 2 samples 3 } } }
