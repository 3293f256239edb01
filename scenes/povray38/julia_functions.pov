#version 3.8;
// A hypercomplex set of a function: the test for the inside starts where it should.
global_settings { assumed_gamma 1 }
camera { location <3, 4, -12> look_at 0 angle 40 }
light_source { <4, 8, -16>, rgb 1 }
julia_fractal { <-0.083, 0, -0.83, -0.025> hypercomplex exp max_iteration 3 precision 5 slice <0.3, 0.2, 0.1, 1>, 0.1
  pigment { rgb <0.9, 0.6, 0.3> } finish { ambient 0.15 diffuse 0.7 } }
