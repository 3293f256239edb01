// An isosurface of hyperbolic functions: sinh and cosh, their ranges and their values, one at a time.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 0.78 s, Whittle 0.47 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 45 }
light_source { <-6, 8, -7>, 1 }
background { rgb <.5, .6, .8> }
isosurface {
  function { cosh(2*x) - 2*cosh(y) + sinh(z*z) - .5 }
  contained_by { box { -1.5, 1.5 } }
  max_gradient 20
  pigment { rgb <.9, .7, .5> }
  finish { phong .4 }
}
plane { y, -1.6 pigment { checker rgb .4, rgb .8 } }
