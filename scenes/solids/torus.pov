// Tori: upright, lying, thin, and one that overlaps itself (minor radius larger than major).
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.5, -6> look_at <0, 0, 0> angle 52 }
light_source { <-4, 7, -5> rgb 1 }
background { rgb <0.15, 0.15, 0.2> }

torus { 0.7, 0.25 pigment { rgb <0.8, 0.4, 0.3> } rotate 80*x translate <-1.9, 0.2, 0> }
torus { 0.7, 0.25 pigment { rgb <0.4, 0.7, 0.4> } }
torus { 1.3, 0.05 pigment { rgb <0.8, 0.8, 0.3> } rotate 10*z }
torus { 0.3, 0.5 pigment { rgb <0.4, 0.5, 0.8> } rotate -60*x translate <2, 0.2, 0> }
plane { y, -1 pigment { rgb 0.6 } }
