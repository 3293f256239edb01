#version 3.8;
// One picture decoded by four curves, from the left: srgb, bt709, bt2020 and a power; below the same as heights of bumps.
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> look_at 0 right 4*x up 3*y }
light_source { <-3, 4, -8>, 1 }

#macro Tile(Left, Colors, Bumps)
  box { <Left, 0, 0>, <Left + 0.95, 1.3, 1> pigment { Colors translate Left*x } finish { ambient 0 emission 1 diffuse 0 } }
  box { <Left, -1.3, 0>, <Left + 0.95, -0.1, 1> pigment { rgb <0.6, 0.7, 0.8> } normal { Bumps translate Left*x } }
#end
Tile(-2, pigment { image_map { png "../pigment/weave.png" gamma srgb } }, normal { bump_map { png "../pigment/weave.png" gamma srgb bump_size 4 } })
Tile(-1, pigment { image_map { png "../pigment/weave.png" gamma bt709 } }, normal { bump_map { png "../pigment/weave.png" gamma bt709 bump_size 4 } })
Tile(0, pigment { image_map { png "../pigment/weave.png" gamma bt2020 } }, normal { bump_map { png "../pigment/weave.png" gamma bt2020 bump_size 4 } })
Tile(1, pigment { image_map { png "../pigment/weave.png" gamma 2.2 } }, normal { bump_map { png "../pigment/weave.png" gamma 2.2 bump_size 4 } })
