// A mesh with an inside_vector in every operation: intersection, difference both ways, union and merge of glass,
// inverse, clipped_by and clipping.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 }
camera { location <0.4, 3.2, -8> look_at <0, -0.2, 0> angle 46 }
light_source { <-4, 7, -6> rgb 1 }
plane { y, -2.2 pigment { checker rgb 0.75, rgb <0.5, 0.55, 0.5> } }

// A ring of square section: four crossings along many rays.
#declare N = 14;
#macro Corner(I, K)
  #local A = 2*pi*I/N;
  #local R = 0.75 + 0.28*(K = 0 | K = 3 ? 1 : -1);
  <R*cos(A), (K < 2 ? -0.28 : 0.28), R*sin(A)>
#end
#declare Ring = mesh {
  #for (I, 0, N - 1) #for (K, 0, 3)
    triangle { Corner(I, K), Corner(I + 1, K), Corner(I, mod(K + 1, 4)) }
    triangle { Corner(I + 1, K), Corner(I + 1, mod(K + 1, 4)), Corner(I, mod(K + 1, 4)) }
  #end #end
  inside_vector <0.31, 1, 0.17>
}
#declare Clay = texture { pigment { rgb <0.85, 0.5, 0.3> } }
#declare Chalk = texture { pigment { rgb <0.85, 0.85, 0.75> } finish { phong 0.4 } }
#declare Glass = texture { pigment { rgbf <0.8, 0.95, 0.85, 0.85> } finish { phong 0.6 } }

intersection { object { Ring texture { Clay } } box { <-2, -1, -0.6>, <2, 1, 0.5> texture { Chalk } } rotate <-50, 10, 0> translate <-2.4, 1, 0> }
difference { object { Ring texture { Clay } } sphere { <0.5, 0.3, -0.6>, 0.6 texture { Chalk } } rotate <-50, 20, 0> translate <0, 1, 0> }
difference { box { -0.8, 0.8 texture { Chalk } } object { Ring rotate 90*x translate -0.8*z texture { Clay } } rotate <-20, 30, 0> translate <2.4, 1, 0> }
merge { object { Ring } sphere { 0, 0.6 } texture { Glass } interior { ior 1.2 } rotate <-50, 10, 0> translate <-2.4, -1.1, 0> }
union { object { Ring } box { <-1, -0.1, -0.1>, <1, 0.1, 0.1> } texture { Glass } rotate <-50, 10, 0> translate <-0.8, -1.1, -0.4> }
intersection { sphere { 0, 0.85 texture { Chalk } } object { Ring inverse texture { Clay } } rotate <-50, 10, 0> translate <0.9, -1.1, 0.1> }
object { Ring texture { Clay } clipped_by { plane { x, 0.2 } } rotate <-60, 30, 0> translate <2.4, -1.2, -0.4> }
sphere { 0, 0.9 texture { Chalk } clipped_by { object { Ring rotate 40*z } } translate <3.2, -1.2, 1.4> }
