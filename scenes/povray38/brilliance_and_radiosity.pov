#version 3.8;
// Light that comes from all around falls by the finish's brilliance too: above 1 darker where it comes in flat.
global_settings { assumed_gamma 1 radiosity { count 1200 error_bound 0.1 recursion_limit 2 nearest_count 8 pretrace_end 0.02 } }
camera { location <0, 1.6, -5> look_at <0, 0.3, 0> angle 52 }
sphere { 0, 50 hollow pigment { gradient y color_map { [0.5 rgb 0.2] [1 rgb <0.9, 0.95, 1>] } scale 100 translate -50*y } finish { emission 1 diffuse 0 } }
plane { y, -0.6 pigment { rgb <0.8, 0.7, 0.6> } finish { diffuse 0.7 } }
sphere { <-1.5, 0, 0>, 0.6 pigment { rgb <0.9, 0.6, 0.5> } finish { diffuse 0.8 } }
sphere { 0, 0.6 pigment { rgb <0.9, 0.6, 0.5> } finish { diffuse 0.8 brilliance 4 } }
sphere { <1.5, 0, 0>, 0.6 pigment { rgb <0.9, 0.6, 0.5> } finish { diffuse 0.8 brilliance 0.3 } }
