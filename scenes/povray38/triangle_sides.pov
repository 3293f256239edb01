#version 3.8;
// Which side of a triangle is which goes by the order of its corners, moved or not.
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 8*x up 6*y direction z }
light_source { <3, 4, -8>, rgb 1 }
#declare Outer = texture { pigment { rgb <0.9, 0.5, 0.3> } finish { ambient 0.3 emission 0 diffuse 0.7 } }
#declare Inner = texture { pigment { rgb <0.3, 0.5, 0.9> } finish { ambient 0.3 emission 0 diffuse 0.7 } }
#declare A = <-0.7, -0.7, 0>; #declare B = <0.7, -0.7, 0.2>; #declare C = <0, 0.7, 0>;
triangle { A, B, C texture { Outer } interior_texture { Inner } }
triangle { A, C, B texture { Outer } interior_texture { Inner } translate -2*x }
triangle { A, B, C texture { Outer } interior_texture { Inner } rotate 180*y translate 2*x }
triangle { A, B, C texture { Outer } interior_texture { Inner } scale <-1, 1, 1> translate <-2, 2, 0> }
triangle { A, C, B texture { Outer } interior_texture { Inner } rotate 90*z translate 2*y }
smooth_triangle { A, -z, B, -z, C, -z texture { Outer } interior_texture { Inner } translate <2, 2, 0> }
smooth_triangle { A, z, B, z, C, z texture { Outer } interior_texture { Inner } translate <-2, -2, 0> }
mesh { triangle { A, B, C } texture { Outer } interior_texture { Inner } translate -2*y }
mesh { triangle { A, C, B } texture { Outer } interior_texture { Inner } translate <2, -2, 0> }
