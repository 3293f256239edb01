#version 3.8;
// Eggs whose spheres stand apart, joined by arcs of chosen radii.
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -8> look_at <0, 0.6, 0> angle 48 }
light_source { <4, 8, -6>, rgb 1 }
#declare Look = finish { ambient 0.15 diffuse 0.7 specular 0.4 roughness 0.02 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.5 } finish { ambient 0.1 diffuse 0.7 } }
ovus { 0.6, 0.3 pigment { rgb <0.9, 0.8, 0.6> } finish { Look } translate -2.8*x }
ovus { 0.6, 0.3 distance 1.4 pigment { rgb <0.9, 0.5, 0.3> } finish { Look } translate -1.4*x }
ovus { 0.6, 0.3 distance 1.4 radius 6 pigment { rgb <0.5, 0.8, 0.4> } finish { Look } }
ovus { 0.35, 0.7 radius 2.1 distance 1.05 precision 0.000001 sturm pigment { rgb <0.4, 0.6, 0.9> } finish { Look } rotate -20*z translate 1.5*x }
difference {
  ovus { 0.6, 0.6 distance 1.2 radius 1.5 }
  plane { z, -0.2 }
  pigment { rgb <0.8, 0.5, 0.8> } finish { Look } translate 3*x
}
