// Highlights on normals that no_bump_scale leaves longer than 1: powers of cosines above 1, more than a float holds, and white.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { orthographic location <0, 0, -10> look_at 0 right 8*x up 6*y }
light_source { <-20, 30, -40> rgb 1 }
background { rgb <0.1, 0.15, 0.2> }

#declare Sharp = finish { specular 0.3 roughness 0.001 }
#declare Sharpest = finish { phong 0.3 phong_size 9000 }
#declare Metal = finish { specular 0.3 roughness 0.01 metallic }
#declare Wide = finish { specular 0.3 roughness 0.005 }
#declare Both = finish { phong 1 phong_size 40 specular 0.5 }
#declare Whole = finish { specular 1 roughness 0.02 }

#macro Ball(X, Y, Size, Color, Finish)
  sphere {
    <X, Y, 0>, 1.2
    texture {
      gradient y no_bump_scale
      texture_map {
        [0 pigment { rgb 0.5 } normal { bumps 0.3 scale 0.2 } finish { Finish }]
        [1 pigment { Color } normal { bumps 0.3 scale 0.2 } finish { Finish }]
      }
      scale Size
    }
  }
#end
Ball(-2.6, 1.5, 0.4, rgb <1, 0, 0>, Sharp)
Ball(0, 1.5, 0.4, rgb <1, 0, 0>, Sharpest)
Ball(2.6, 1.5, 0.9, rgb <0, 0.6, 0.3>, Metal)
Ball(-2.6, -1.5, 0.7, rgbt <0.2, 0.4, 1, 0.5>, Wide)
Ball(0, -1.5, 0.5, rgb <1, 0.8, 0.2>, Both)
Ball(2.6, -1.5, 2, rgb <1, 0, 1>, Whole)
