// Sphere sweeps of each spline, and as operands.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.4, 5, -9> look_at <0, 0.1, 0> angle 46 }
light_source { <-4, 9, -8> rgb 1 }
background { rgb 0.3 }
#declare Hook = sphere_sweep { linear_spline 4, <-1, -0.5, 0>, 0.2, <-0.4, 0.6, 0>, 0.35, <0.5, 0.3, 0>, 0.15, <0.9, -0.5, 0>, 0.4 }
#declare Coil = sphere_sweep {
  b_spline 9
  #for (I, 0, 8) , <cos(I*1.3), -0.8 + 0.2*I, sin(I*1.3)>, 0.15 + 0.02*I #end
  tolerance 0.0001
}
object { Hook pigment { rgb <0.9, 0.6, 0.2> } rotate 20*y translate <-2.6, 0, 1> }
object { Coil pigment { rgb <0.3, 0.6, 0.9> } translate 1.2*z }
sphere_sweep {
  cubic_spline 6, <-1, -1, 0>, 0.2, <-0.9, 0, 0.3>, 0.15, <-0.2, 0.7, 0>, 0.4, <0.4, -0.3, -0.3>, 0.2, <1, 0.3, 0>, 0.35, <1.5, 1, 0>, 0.2
  tolerance 0.0001
  scale <1, 1.2, 0.8> rotate -20*y
  pigment { rgb <0.5, 0.8, 0.3> } translate <2.8, 0, 1>
}
difference { object { Hook } plane { z, -0.1 } pigment { rgb <0.8, 0.4, 0.6> } scale 0.8 translate <-2.2, 0, -2> }
intersection { box { <-0.9, -0.4, -0.15>, <0.9, 0.5, 0.6> } object { Hook inverse } pigment { rgb <0.5, 0.8, 0.7> } translate <0, 0, -2.2> }
object { Hook clipped_by { plane { <0.2, 0.2, -1>, 0.05 } } pigment { rgb <0.9, 0.5, 0.3> } scale 0.8 translate <2.2, 0, -2> }
