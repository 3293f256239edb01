#version 3.8;
// A picture as of a mirror ball as heights and as materials, its levels by three curves.
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 45 }
light_source { <-4, 6, -6>, 1 }
sphere { 0, 0.9 pigment { rgb <0.8, 0.8, 0.9> } normal { bump_map { png "../pigment/weave.png" gamma bt709 map_type 7 interpolate 2 bump_size 2 } } translate -1.1*x }
sphere { 0, 0.9
  texture {
    image_pattern { png "../pigment/weave.png" gamma bt2020 map_type 7 interpolate 2 }
    texture_map { [0.3 pigment { rgb <0.2, 0.3, 0.6> } finish { phong 0.7 }] [0.7 pigment { rgb <0.9, 0.8, 0.5> } normal { bumps 0.5 scale 0.1 }] }
  }
  translate 1.1*x
}
