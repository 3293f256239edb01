// Conic prisms of every spline: through their apex, below it, open, with a hole, turned and stretched, cut, clipped, cutting,
// inside out.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.7, 5.5, -9> look_at <0, 0.6, 0> angle 46 }
light_source { <-6, 10, -12> rgb 1 }
background { rgb 0.25 }
#declare Square = prism { conic_sweep linear_spline 0.2, 1.2, 10, <-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1>, <-0.5,-0.4>,<0.5,-0.4>,<0.5,0.6>,<-0.5,0.4>,<-0.5,-0.4> }
#declare Petal = prism { conic_sweep cubic_spline -1, 1, 8, <0,-1>,<1,0>,<0.5,1>,<-0.3,0.7>,<-1,0>,<0,-1.2>,<1,0>,<0,1> }
#declare Leaf = prism { conic_sweep bezier_spline 0, 1, 8, <1,0>,<1,0.6>,<0.6,1>,<0,1>,<0,1>,<-1,1>,<-1,-0.5>,<1,0> }
#declare Shell = prism { conic_sweep quadratic_spline 0.3, 1.3, 6, <1,-1>,<1,0>,<0,1>,<-1,0>,<0,-1>,<1,0> open }
object { Square pigment { rgb <0.8, 0.5, 0.2> } rotate 180*x translate <-3, 1.3, 1.4> }
object { Petal pigment { rgb <0.3, 0.6, 0.8> } finish { specular 0.5 } translate <-0.9, 1, 2> }
object { Leaf pigment { rgb <0.5, 0.8, 0.3> } scale <1.2, 1.8, 0.8> rotate <20, -30, 10> translate <1.4, 0.4, 1.6> }
object { Shell pigment { rgb <0.8, 0.3, 0.5> } interior_texture { pigment { rgb <0.2, 0.3, 0.9> } } rotate -40*x translate <3.5, 0, 1.4> }
difference { object { Petal scale <1, 1.3, 1> } box { <0, -2, -2>, <2, 2, 0.1> } pigment { rgb <0.9, 0.8, 0.4> } translate <-2.9, 1, -1> }
difference { box { <-0.8, 0, -0.8>, <0.8, 1.1, 0.8> } object { Leaf scale <0.7, 1.2, 0.7> } object { Square scale 0.7 translate <0.3, 0.6, -0.8> } pigment { rgb <0.5, 0.5, 0.9> } translate <-1, 0, -1.4> }
intersection { sphere { <0, 0.8, 0>, 0.9 } object { Petal inverse translate <0.2, 0.8, -0.4> } pigment { rgb <0.3, 0.8, 0.7> } translate <1.1, 0, -1.4> }
object { Square clipped_by { plane { <0.3, 0.2, -1>, 0.2 inverse } } pigment { rgb <0.9, 0.4, 0.3> } translate <2.9, 0, -1> }
plane { y, 0 pigment { rgb 0.5 } }
