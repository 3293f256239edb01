// The same numbers in another order give another picture: angle before right, look_at before sky.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <-3, 2, -4> look_at <0, 0.5, 0> sky <1, 1, 0> angle 50 right 1.6*x }
light_source { <-2, 6, -5> rgb 1 }
background { rgb <0.4, 0.5, 0.6> }
box { <-0.5, 0, -0.5>, <0.5, 1, 0.5> pigment { rgb <0.8, 0.5, 0.3> } }
torus { 0.8, 0.15 translate 0.15*y pigment { rgb <0.8, 0.8, 0.4> } }
plane { y, 0 pigment { checker rgb 0.8, rgb 0.5 } }
