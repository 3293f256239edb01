// Light that is mirrored within, wavelength by wavelength, takes on the iridescence of the surface: the rims of bodies with an ior below 1.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -5> look_at 0 angle 50 }
light_source { <-5, 9, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, -1.5 pigment { checker rgb 1, rgb 0.3 } }
sphere {
    <-1.1, 0, 0>, 1 pigment { rgbf 1 } finish { diffuse 0 ambient 0 irid { 0.6 thickness 0.4 } }
    interior { ior 0.8 dispersion 1.1 dispersion_samples 8 }
}
box {
    <-0.8, -0.8, -0.8>, 0.8 rotate <20, 30, 0> translate 1.2*x pigment { rgbt 0.9 }
    finish { reflection 0.2 irid { 0.5 thickness 0.3 turbulence 0.2 } } interior { ior 0.85 dispersion 1.05 dispersion_samples 3 }
}
