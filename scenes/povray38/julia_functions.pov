#version 3.8;
// Hypercomplex sets of functions: the test for the inside starts where it should.
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at 0 angle 40 }
light_source { <4, 8, -6>, rgb 1 }
#declare Look = finish { ambient 0.15 diffuse 0.7 }
julia_fractal { <-0.5, 0.2, 0.3, -0.2> hypercomplex pwr(3, 0) max_iteration 5 precision 10 slice <0.2, 0.1, 0.1, 1>, 0.05
  pigment { rgb <0.9, 0.6, 0.3> } finish { Look } scale 0.9 translate -1.4*x }
julia_fractal { <0.1, 0.6, 0.2, 0.1> hypercomplex sinh max_iteration 3 precision 8 slice <0, 0.1, 0, 1>, 0
  clipped_by { sphere { 0, 1.3 } } pigment { rgb <0.4, 0.6, 0.9> } finish { Look } translate 1.4*x }
