// A range made by a function (height_field), snow where it is not steep (slope), mist in the valleys (fog) and a rainbow.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
#default { finish { ambient 0 } }

camera { location <0, 1.5, -5> right 4/3*x look_at <0, 1.55, 0> angle 50 }
light_source { <-40, 19, -46> rgb <1.0, 0.78, 0.54>*1.45 parallel point_at 0 }
light_source { <30, 60, -60> rgb <0.40, 0.55, 0.85>*0.35 shadowless parallel point_at 0 }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.86, 0.66, 0.52>] [0.16 rgb <0.55, 0.60, 0.70>] [0.5 rgb <0.14, 0.26, 0.50>] [1 rgb <0.05, 0.12, 0.32>] } }
  pigment {
    bozo turbulence 0.7 octaves 5 omega 0.55 lambda 2.3 scale <0.45, 0.10, 0.3>
    color_map { [0.50 rgbt 1] [0.72 rgbt <0.95, 0.82, 0.76, 0.25>] [1 rgbt <0.75, 0.66, 0.68, 0.1>] }
  }
}
#include "functions.inc"
// Ridges: where noise passes its middle the land is highest, and finer ridges stand on coarse ones.
#declare Ridge = function(x, y, z) { pow(1 - abs(2*f_noise3d(x, y, z) - 1), 2) }
#declare Land = function(x, z) { 0.62*Ridge(x, 7.3, z) + 0.25*Ridge(x, 7.3, z)*Ridge(2.2*x, 3.1, 2.2*z) + 0.12*Ridge(5*x, 1.7, 5*z) + 0.05*Ridge(11*x, 2.9, 11*z) + 0.025*Ridge(24*x, 1, 24*z) }
height_field {
  function 800, 800 { max(0, min(1, Land(5*x + 1.2, 4*y + 0.4)*(1.05 - 0.75*y) - 0.20*y)) }
  smooth
  translate <-0.5, 0, 0> scale <15, 3.6, 12>
  texture {
    slope { 0.5*y, 0.1, 0.95 altitude 0.5*y, 0.4, 3.0 }
    texture_map {
      [0.40 pigment { granite scale <2, 0.5, 2> color_map { [0.2 rgb <0.10, 0.085, 0.09>] [0.8 rgb <0.28, 0.22, 0.19>] } } normal { granite 0.5 scale 0.5 } finish { diffuse 0.8 }]
      [0.56 pigment { rgb <0.24, 0.19, 0.17> } normal { granite 0.5 scale 0.5 } finish { diffuse 0.8 }]
      [0.62 pigment { rgb <0.88, 0.90, 0.95> } finish { diffuse 0.85 }]
    }
  }
}
plane { y, 0.5 pigment { rgb <0.015, 0.05, 0.07> } normal { bumps 0.02 scale <0.09, 0.05, 0.03> } finish { diffuse 0.4 reflection { 0.12, 0.8 } } }
fog { fog_type 2 distance 26 fog_offset 0.5 fog_alt 0.35 rgb <0.80, 0.72, 0.72> turbulence 0.2 turb_depth 0.3 }
rainbow {
  direction <40, -19, 46> angle 42 width 5 distance 1000 arc_angle 180
  color_map {
    [0.00 rgbt <0.6, 0.4, 0.9, 1>] [0.20 rgbt <0.5, 0.4, 0.9, 0.80>] [0.40 rgbt <0.3, 0.7, 0.7, 0.72>]
    [0.60 rgbt <0.7, 0.9, 0.3, 0.72>] [0.80 rgbt <1.0, 0.6, 0.2, 0.75>] [1.00 rgbt <1.0, 0.3, 0.2, 1>]
  }
}
