// Photons that clear prisms split into colours, with coloured glass on their way. POV-Ray filters only the first colour by the prism; each
// later one by the glass that the colour before it has met last.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 photons { spacing 0.03 gather 24, 80 } }
camera { location <0, 5, -7.5> look_at <0, 1.1, .4> angle 42 }
background { rgb .05 }
plane { y, 0 pigment { rgb .85 } finish { ambient 0 diffuse .9 } }
light_source { <-1, 12, -2>, rgb .9 photons { refraction on reflection off } }

#macro Glass(Color, Through, Spread)
  pigment { rgbf <Color.x, Color.y, Color.z, Through> }
  finish { ambient 0 diffuse 0 specular .4 }
  interior { ior 1.4 dispersion Spread dispersion_samples 5 }
  photons { target refraction on collect off }
#end

#declare Prism = prism { -.8, .8, 4, <-.7, 0>, <.7, 0>, <0, 1.1>, <-.7, 0> rotate -90*x }

// Coloured glass below, in the prism and on its other side.
object { Prism translate <-2, 1.4, .8> Glass(<1, 1, 1>, .95, 1.12) }
box { <-2.7, .8, 0>, <-1.3, 1, 1.6> Glass(<1, .6, .3>, .9, 1) }
object { Prism translate <0, 1.2, .8> Glass(<1, 1, 1>, .95, 1.12) }
cylinder { <0, 1.5, -.3>, <0, 1.5, 1.9>, .25 Glass(<.4, .9, .5>, .9, 1) }
object { Prism translate <2, .8, .8> Glass(<1, 1, 1>, .95, 1.12) }
sphere { <2, 2.6, .8>, .6 Glass(<.5, .6, 1>, .9, 1) }
