// Prisms of every spline, one with a hole, one open and cut.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <1, 6, -9> look_at <0, 0.3, 0> angle 45 }
light_source { <-4, 8, -10> rgb 1 }
background { rgb 0.3 }
prism { 0, 1, 10, <-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1>, <-0.5,-0.5>,<0.5,-0.5>,<0.5,0.5>,<-0.5,0.5>,<-0.5,-0.5> pigment { rgb <0.8,0.5,0.2> } translate <-2.4, 0, 1> }
prism { quadratic_spline 0, 1, 6,<1,-1>,<1,0>,<0,1>,<-1,0>,<0,-1>,<1,0> pigment { rgb <0.2,0.5,0.8> } }
prism { cubic_spline 1, 0, 7,<0,-1>,<1,0>,<0,1>,<-1,0>,<0,-1>,<1,0>,<0,1> pigment { rgb <0.5,0.8,0.3> } translate 2.4*x }
prism { bezier_spline 0, 0.6, 8,<1,0>,<1,.6>,<.6,1>,<0,1>,<0,1>,<-1,1>,<-1,-.5>,<1,0> pigment { rgb <0.8,0.3,0.5> } translate -2.4*z }
difference { prism { linear_sweep cubic_spline 0, 0.8, 7,<0,-1>,<1,0>,<0,1>,<-1,0>,<0,-1>,<1,0>,<0,1> open } sphere { <0.3,0.8,0>, 0.6 } pigment { rgb 0.8 } translate <-2.6,0,-2> }
