// A tree in haze under an open sky: media that scatter everywhere, up to the farthest distance.
// bench: +W640 +H480 -A
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,2.5,-9> look_at <0,1.5,0> angle 45 }
light_source { <8,10,-6> rgb 1.5 }
media { scattering { 1, 0.03 } samples 6 }
#declare Leaf = mesh { smooth_triangle { <0,0,0>,<0,0.3,-1>,<0.2,0.1,0>,<0.5,0.5,-1>,<0,0.6,0>,<0,0.3,-1> } smooth_triangle { <0,0,0>,<0,0.3,-1>,<-0.2,0.1,0>,<-0.5,0.5,-1>,<0,0.6,0>,<0,0.3,-1> } }
#macro Branch(P, D, L, N, S)
  #local Rr = seed(S);
  #local Q = P + D*L;
  cone { P, 0.03*N, Q, 0.03*max(N-1,0.4) pigment { rgb <0.4,0.25,0.12> } }
  #if (N > 1)
    #for (K,1,3)
      #local A = vnormalize(D + 0.9*<rand(Rr)-0.5, 0.3*rand(Rr), rand(Rr)-0.5>);
      Branch(Q, A, L*0.75, N-1, S*3+K)
    #end
  #else
    object { Leaf scale 0.4 rotate <rand(Rr)*40,rand(Rr)*360,rand(Rr)*40> translate Q pigment { rgb <0.15,0.5+0.2*rand(Rr),0.1> } }
  #end
#end
union { Branch(<0,0,0>, y, 1.0, 5, 7) }
plane { y,0 pigment { rgb <0.35,0.5,0.25> } }
sphere { <2.6,0.8,-0.5>,0.8 hollow pigment { rgbt 1 } interior { media { emission <0.4,0.2,0.05>*1.5 method 3 samples 5 intervals 1 density { spherical scale 0.8 turbulence 0.4 translate <2.6,0.8,-0.5> color_map { [0 rgb 0][0.5 rgb <0.4,0.1,0>][1 rgb <1,0.9,0.5>] } } } } }
