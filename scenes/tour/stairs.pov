// A stairwell lit by the sky alone: each wall gets its light from the others (radiosity).
#version 3.7;
global_settings {
  assumed_gamma 1 max_trace_level 4
  radiosity { pretrace_start 0.08 pretrace_end 0.01 count 180 nearest_count 8 error_bound 0.3 recursion_limit 3 low_error_factor 0.6 gray_threshold 0 brightness 1.5 }
}
#default { finish { ambient 0 diffuse 0.8 } }

camera { location <4.2, 2.6, -9.3> right 4/3*x look_at <-0.35, 2.75, 0> angle 52 }
sky_sphere { pigment { rgb <0.78, 0.92, 1.15>*1.25 } }
light_source { <-30, 26, -13> rgb <1.0, 0.85, 0.62>*3.2 parallel point_at 0 }

#declare White = <0.86, 0.84, 0.80>;
difference {                                      // The room, with a tall window on the left and a skylight
  box { <-5.4, -0.4, -10.4>, <5.4, 7.4, 4.4> }
  box { <-5, 0, -10>, <5, 7, 4> }
  box { <-6, 1.0, -3.2>, <-4, 6, -0.6> }
  box { <-6, 1.0, 0.0>, <-4, 6, 2.6> }
  cylinder { <0, 6, 0>, <0, 8, 0>, 1.5 }
  pigment { rgb White }
}
box { <-5, 0, 3.98>, <5, 7, 4> pigment { rgb <0.70, 0.20, 0.11> } }
box { <4.98, 0, -10>, <5, 7, 4> pigment { rgb <0.12, 0.36, 0.42> } }
box { <-5, 0, -10>, <5, 0.02, 4> pigment { rgb <0.46, 0.32, 0.20> } finish { reflection { 0.02, 0.25 } } }
// The stairs: a loop of steps around a column, each a little higher and turned on.
#declare Steps = 22;
#for (I, 0, Steps)
  intersection {
    cylinder { 0, 0.14*y, 2.3 }
    plane { z, 0 rotate 9*y } plane { -z, 0 rotate -13*y }
    rotate (I*17 - 60)*y translate (0.24 + I*0.30)*y
    pigment { rgb White }
  }
  cylinder { 0, 0.95*y, 0.025 translate 2.2*x rotate (I*17 - 60)*y translate (0.3 + I*0.30)*y pigment { rgb 0.05 } }
  #local A = (I*17 - 60)*pi/180; #local B = A + 17*pi/180;
  cylinder { <2.2*cos(A), 1.25 + I*0.30, -2.2*sin(A)>, <2.2*cos(B), 1.55 + I*0.30, -2.2*sin(B)>, 0.04 pigment { rgb <0.45, 0.25, 0.1> } }
#end
cylinder { 0, 7*y, 0.32 pigment { rgb White } }
sphere { <-2.9, 0.55, -2.9>, 0.55 pigment { rgb <0.95, 0.70, 0.16> } }
