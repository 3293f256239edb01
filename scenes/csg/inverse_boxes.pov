// A union or merge of a solid turned inside out has for POV-Ray the box of what it leaves out, and so has what it cuts: nothing
// of it is seen by rays that miss that box. Cut once alone, deep inside, subtracted, as a clip and turned.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 0.6, -9> look_at 0 angle 50 }
light_source { <-5, 9, -8> rgb 0.6 shadowless }
background { rgb <0.3, 0.5, 0.8> }
#default { finish { ambient 0.5 diffuse 0.5 } }

intersection { plane { x, 0 } union { sphere { 0, 0.7 inverse } } pigment { rgb <0.2, 0.7, 0.3> } rotate 20*y translate <-2.6, 1.8, 0> }
merge {
  intersection { plane { x, 0 } merge { sphere { 0, 0.7 inverse } box { 0, 0.2 } } }
  box { <0.2, -1, 0>, <1, 1, 1> }
  pigment { rgb <0.9, 0.6, 0.3> } translate <0, 1.8, 0>
}
difference {
  box { -1, 1 }
  intersection { plane { x, 0 } union { sphere { -z, 0.7 inverse } } }
  pigment { rgb <0.8, 0.4, 0.4> } rotate 20*y translate <2.8, 1.8, 0>
}
box { -1, 1 clipped_by { union { sphere { -0.5*z, 0.8 inverse } } } pigment { rgb <0.7, 0.5, 0.9> } rotate 25*y translate <-2.6, -1.4, 0> }
intersection { box { -1, 1 } union { sphere { 0, 0.7 inverse } box { -0.5, 0.8 } rotate 30*y } pigment { rgb <0.4, 0.8, 0.9> } translate <0, -1.4, 0> }
intersection { box { -1, 1 } union { cylinder { -z, z, 0.5 inverse } } pigment { rgb <0.8, 0.8, 0.5> } rotate 20*y translate <2.8, -1.4, 0> }
