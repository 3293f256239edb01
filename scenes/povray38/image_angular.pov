#version 3.8;
// A picture as of a mirror ball: all around a ball and on the inside of a box, with and without interpolation.
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 46 }
light_source { <-4, 6, -8>, 1 }

#declare Rings = pigment {
  image_map {
    function 64, 64 { pigment { onion translate <0.5, 0.5, 0> scale 0.2 color_map { [0 rgb <0.9, 0.3, 0.1>] [1 rgb <0.1, 0.4, 0.9>] } } }
    map_type 7
  }
}
#declare Squares = pigment {
  image_map { function 48, 48 { pigment { checker rgb <0.9, 0.9, 0.5> rgb <0.2, 0.5, 0.3> scale 0.125 } } map_type 7 interpolate 2 }
}
sphere { <-1.1, 0, 0>, 1 pigment { Rings translate <-1.1, 0, 0> } }
sphere { <1.1, 0, 0>, 1 pigment { Squares rotate 180*y translate <1.1, 0, 0> } }
box { -8, 8 hollow pigment { Squares } finish { ambient 0.2 } }
