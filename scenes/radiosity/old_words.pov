// Version 3.6: ambient is added, grey and bright samples; light from behind, bumps that count.
#version 3.6;
global_settings {
  assumed_gamma 1
  radiosity { count 80 error_bound 0.5 recursion_limit 2 gray_threshold 0.5 brightness 1.4 normal on max_sample 1.5
              minimum_reuse 0.02 always_sample off low_error_factor 0.7 }
}
#default { finish { ambient 0.05 diffuse 0.7 } radiosity { importance 0.6 } }
camera { location <0, 2, -4.6> look_at <0, 0.8, 0> angle 46 }
background { rgb <0.45, 0.5, 0.6> }
light_source { <-6, 7, -4>, rgb <0.7, 0.65, 0.6> }
plane { y, 0 pigment { rgb <0.8, 0.75, 0.6> } normal { bumps 0.5 scale 0.4 } }
disc { <-0.9, 0.9, 0.3>, <0.3, 0.1, -1>, 0.8 pigment { rgb <0.9, 0.8, 0.3> } finish { diffuse 0.5, 0.5 } }
sphere { <0.9, 0.7, 0.2>, 0.7 pigment { marble color_map { [0 rgb 0.9] [1 rgb <0.4, 0.5, 0.8>] } } radiosity { importance 1 } }
box { <-0.3, 0, -1>, <0.3, 0.5, -0.5> pigment { rgb <1, 0.5, 0.2> } finish { emission 0.6 } }
