// Every operator, promotion from float to vector to colour, and the functions of a scene's arithmetic.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2, -7> look_at <0, 0.3, 0> angle 46 }
light_source { <-3, 6, -5> rgb 1 }

#declare A = 3 + 4*2 - 6/4;                                     // 9.5
#declare V = <1, 2, 3>*0.5 + 1 - vcross(x, y);                  // 1.5 2 1.5
#declare C = rgbf <0.2, 0.4, 0.9, 0.5>*1.2;                       // all five parts
#declare Truth = ((A > 9) & !(A = 9) | (A != A));               // 1
#declare S = select(A - 9.5, 0.2, 0.4, 0.8);                    // 0.4

sphere { <-2.4, 0, 0> + V.y*0.1*y, S pigment { color C } }
sphere { <-1.2, mod(7.5, 2)/4, 0>, 0.4*Truth pigment { color C*0.5 } }
sphere { <0, min(0.2, 0.5, 0.3), max(0.1, 0)>, sqrt(0.25) pigment { rgb <abs(-0.8), pow(0.5, 2), exp(-1)> } }
sphere { vrotate(<1.3, 0, 0>, <0, -20, 10>), vlength(<0.3, 0.4, 0>)*(3 >= 2 ? 1 : 2) pigment { rgb vnormalize(<1, 2, 2>) } }
box { <2, int(0.9), -0.3>, <2.6, ceil(0.2)*0.7, floor(0.9) + 0.3> pigment { rgb (<1, 1, 0> + <0.2, -0.4, 0.6>)*0.8 } rotate degrees(pi/30)*z }
cylinder { <0, -0.6, -1>, vaxis_rotate(<0.9, -0.6, -1>, y, -30), 0.5*max(0, min(0.9, 0.2)) pigment { rgb vdot(<1, 2, 3>, <0.1, 0.1, 0.1>) } }
plane { y, -0.8 pigment { rgb <sin(pi/6), cos(pi/3), tan(pi/4)*0.6> } }
