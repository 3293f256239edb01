// Bounds that matter: parts beyond them show only to rays that meet the bound.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -11> look_at <0, 0, 0> angle 42 }
light_source { <-5, 8, -10> rgb 1 }
background { rgb <0.22, 0.24, 0.3> }

// A sheet without end, bounded by a turned box, by two solids at once.
#declare Saddle = polynomial { 3, xyz(3, 0, 0): 1, xyz(1, 0, 2): -3, xyz(0, 1, 0): -1 }
object { Saddle bounded_by { box { -0.8, 0.8 rotate 45*z } } pigment { rgb <0.4, 0.7, 0.9> } rotate 20*x translate <-2, 1.5, 0> }
object { Saddle bounded_by { sphere { 0.4*x, 1 } sphere { -0.4*x, 1 } } pigment { rgb <0.5, 0.85, 0.4> } rotate 20*x translate <2, 1.5, 0> }
// The bound is the clip.
object { Saddle clipped_by { box { -0.9, 0.9 } } bounded_by { clipped_by } pigment { rgb <0.9, 0.5, 0.5> } rotate 20*x translate <-2, -1.5, 0> }
// CSG wider than its bound.
difference {
  box { <-1.2, -0.8, -0.5>, <1.2, 0.8, 0.5> }
  sphere { <0, 0, -0.6>, 0.6 }
  bounded_by { sphere { 0, 0.75 } }
  pigment { rgb <0.7, 0.5, 0.9> }
  rotate <10, 25, 0> translate <2, -1.5, 0>
}
