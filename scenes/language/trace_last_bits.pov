#version 3.7;
// A walk of which each step begins where trace() put the one before: the last bit of a step decides where the walk is after some dozens.
global_settings { assumed_gamma 1 }
camera { location <0.4, 1.4, -3.5> look_at <0, 1, 0> angle 50 right x*4/3 }
light_source { <-20, 20, -20>, 1 }
#declare Posts = union {
  cylinder { <-0.8, 0, 0>, <-0.8, 2, 0.1>, 0.3 }
  cylinder { <0.7, 2.1, 0>, <0.8, 0, 0>, 0.25 }
  cylinder { <-0.8, 1.2, 0>, <0.8, 1, 0>, 0.2 }
  sphere { <0.05, 0.3, 0>, 0.45 }
  plane { y, 0 }
  translate -0.02*y
}
object { Posts pigment { rgb <0.5, 0.4, 0.3> } }
#declare At = <-0.5, 0.4, -2>;
#declare Along = <-0.1, 0.2, 1>;
#for (I, 0, 250)
  #declare N = <0, 0, 0>;
  #declare P = trace(Posts, At, Along, N);
  #if (vlength(N) > 0)
    sphere { P, 0.03 pigment { rgb <mod(I, 5)/4, I/250, 1 - mod(I, 3)/2> } }
    #declare At = P + 0.7*vnormalize(N - 0.45*Along + <0.02, 0.01, -0.1>);
    #declare Along = vnormalize(<sin(7*P.x) - At.x, 1 + sin(9*P.y) - At.y, sin(5*P.z)/4 - At.z>);
  #else
    #declare At = <sin(40*At.x), 1 + sin(50*At.y), -2>;
    #declare Along = vnormalize(<0, 1, 0> - At);
  #end
#end
