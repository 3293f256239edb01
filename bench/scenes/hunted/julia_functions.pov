// Hypercomplex julia fractals of powers: logarithms, exponentials, sines for each step of each orbit, a ray at a time.
// Whole runs at 320x240 on 28 Nov 2026: POV-Ray 3.05 s, Whittle 2.64 s.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 angle 40 }
light_source { <-6, 8, -7>, 1 }
background { rgb .7 }
#macro Fractal(Where, Tint) pigment { rgb Tint } finish { phong .4 } scale .6 translate Where #end
julia_fractal { <-.2, .4, -.1, 0> hypercomplex pwr(2.5, .1) max_iteration 4 precision 15 Fractal(-.8*x, <.6, .8, .5>) }
julia_fractal { <-.1, .5, -.2, .1> hypercomplex pwr(2.5, .1) max_iteration 5 precision 15 Fractal(.8*x, <.5, .6, .9>) }
plane { y, -1.2 pigment { checker rgb .4, rgb .8 } }
