#version 3.8;
// 'filter all' and 'transmit all' fade what a picture's alpha lets be seen, and leave a picture without one alone.
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> look_at 0 right 4*x up 3*y }
light_source { <-3, 4, -8>, 1 }

plane { z, 2 pigment { checker rgb <0.9, 0.9, 0.6> rgb <0.2, 0.3, 0.6> scale 0.25 } finish { ambient 0 emission 1 diffuse 0 } }
#macro Tile(Corner, Colors)
  box { 0, <0.9, 0.9, 0.1> pigment { Colors } finish { ambient 0 emission 1 diffuse 0 } translate Corner }
#end
Tile(<-1.9, 0.2, 0>, pigment { image_map { png "../pigment/leaf.png" } })
Tile(<-0.9, 0.2, 0>, pigment { image_map { png "../pigment/leaf.png" transmit all 0.4 } })
Tile(<0.1, 0.2, 0>, pigment { image_map { png "../pigment/leaf.png" premultiplied on interpolate 2 filter all 0.6 } })
Tile(<1.1, 0.2, 0>, pigment { image_map { png "../pigment/leaf.png" filter all 0.6 transmit all 0.3 interpolate 2 } })
Tile(<-1.9, -1.1, 0>, pigment { image_map { png "../pigment/weave.png" transmit all 0.4 } })
Tile(<-0.9, -1.1, 0>, pigment { image_map { png "../pigment/weave.png" filter all 0.5 } })
Tile(<0.1, -1.1, 0>, pigment { image_map { function 16, 16 { pigment { bozo scale 0.2 } } transmit all 0.4 } })
Tile(<1.1, -1.1, 0>, pigment { image_map { function 16, 16 { x*y } transmit all 0.4 } })
