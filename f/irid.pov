// Iridescence: its amount, thickness, turbulence and the scene's irid_wavelength.
#version 3.7;
global_settings { assumed_gamma 1 irid_wavelength rgb <0.6, 0.5, 0.4> }
camera { location <0, 3, -7> look_at <0, 0.3, 0> angle 48 }
light_source { <-4, 6, -5>, 1 }
plane { y, -0.7 pigment { rgb 0.5 } finish { irid { 0.3 thickness 0.3 } } }
sphere { <-2, 0, 0>, 0.7 pigment { rgb 0.6 } finish { ambient 0.1 irid { 0.4 thickness 0.2 } } }
sphere { 0, 0.7 pigment { rgb 0.6 } finish { ambient 0.1 irid { 0.4 thickness 0.6 } } }
sphere { <2, 0, 0>, 0.7 pigment { rgb 0.6 } finish { ambient 0.1 irid { 0.6 thickness 0.3 turbulence 0.7 } } }
