// What looks_like shows is moved to its light first; the modifiers behind it act after that, in the scene's own space.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -8> look_at <0, 0.7, 0> angle 45 }
background { rgb <0.1, 0.12, 0.2> }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
light_source { <-6, 8, -7>, 0.6 }
#declare Checks = pigment { checker rgb <0.9, 0.5, 0.2>, rgb <0.2, 0.3, 0.7> scale 0.35 }

// Its pigment within the object moves along; behind it, it stays where the scene has it.
light_source { <-2.3, 1.1, 0.2>, 0.3 looks_like { sphere { 0, 0.7 pigment { Checks } finish { ambient 0.6 } } } }
light_source { <-0.6, 1.1, 0.2>, 0.3 looks_like { sphere { 0, 0.7 } pigment { Checks } finish { ambient 0.6 } } }
// Turned about the scene's axis, and made smaller toward its origin.
light_source { <1.6, 0.4, 0.2>, 0.3 looks_like { box { -0.5, 0.5 } rotate 30*z pigment { Checks } finish { ambient 0.6 } } }
light_source { <3.6, 3.2, 0.4>, 0.3 looks_like { sphere { 0, 1 } scale 0.6 texture { pigment { Checks } finish { ambient 0.6 } } } }
// The light's own transformations take it along.
light_source { <-1, -0.3, -1>, 0.3 looks_like { cylinder { -0.4*y, 0.4*y, 0.4 } pigment { Checks } rotate 20*x finish { ambient 0.6 } } translate -1.2*x }
