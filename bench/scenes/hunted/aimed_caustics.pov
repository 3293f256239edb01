// Photons of two lamps that a lens turns aside to where nothing is: aiming them, their one hit and its texture are all there is.
// Whole runs at 320x240 on 29 Nov 2026: POV-Ray 0.53 s, Whittle 0.26 s.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing .0015 gather 16, 100 } }
camera { location <0, 2, -6> look_at <0, .4, 0> angle 40 }
background { rgb <.5, .6, .8> }
light_source { <-2, 8, 3>, <.8, .7, .6> photons { reflection on refraction on } }
light_source { <3, 8, -1>, <.5, .6, .7> photons { reflection on refraction on } }
intersection {
  sphere { -.6*y, 1 } sphere { .6*y, 1 }
  pigment { rgbf <.8, .9, .9, .9> } finish { diffuse 0 } interior { ior 1.1 }
  translate 1.2*y
  photons { target 1.3 reflection on refraction off collect off }
}
plane { y, 0 pigment { checker rgb .6, rgb .8 } }
