// A room without lamps: a glowing panel lights it, and its walls each other.
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity { count 300 error_bound 0.4 recursion_limit 3 nearest_count 8 pretrace_end 0.02 }
}
camera { location <0.3, 1.4, -3.2> look_at <0, 1.2, 0> angle 62 }
#declare Chalk = finish { diffuse 0.7 }
box { <-2.2, 0, -3.5>, <2.2, 2.6, 2.5> hollow pigment { rgb <0.85, 0.83, 0.78> } finish { Chalk } }
box { <-2.2, 0, -3.5>, <-2.19, 2.6, 2.5> pigment { rgb <0.25, 0.4, 0.8> } finish { Chalk } }
box { <2.19, 0, -3.5>, <2.2, 2.6, 2.5> pigment { rgb <0.8, 0.55, 0.15> } finish { Chalk } }
box { <-0.8, 2.57, -0.6>, <0.8, 2.59, 0.8> pigment { rgb 1 } finish { emission 4 diffuse 0 } }
cylinder { <-0.9, 0, 1>, <-0.9, 1.3, 1>, 0.45 pigment { rgb 0.75 } finish { Chalk } }
sphere { <0.9, 0.5, 0.3>, 0.5 pigment { rgb <0.9, 0.85, 0.8> } finish { Chalk } }
