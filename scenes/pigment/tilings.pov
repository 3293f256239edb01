// All 27 tilings, as colours; in the two lowest rows as bumps and as a texture_map too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 9.2*x up 6.9*y direction z }
light_source { <-20, 30, -40> rgb 1 }
background { rgb 0.1 }

#declare Map = color_map { [0 rgb <0.9, 0.9, 0.7>] [0.35 rgb <0.2, 0.6, 0.3>] [0.7 rgb <0.1, 0.2, 0.6>] [1 rgb <0.8, 0.1, 0.1>] }
#declare Red = texture { pigment { rgb <0.9, 0.2, 0.1> } finish { phong 1 } }
#declare Stripes = texture { pigment { gradient y color_map { [0 rgb 0.2] [1 rgb 1] } scale 0.1 } }

#macro Place(K)
    translate <mod(K, 9) - 4, 2.9 - div(K, 9)*1.12, 0>
#end
#declare Tile = box { <-0.48, -0.48, 0>, <0.48, 0.48, 0.1> }

#for (K, 1, 27)
    object { Tile pigment { tiling K color_map { Map } rotate -90*x scale 0.19 } finish { ambient 1 diffuse 0 } Place(K - 1) }
#end
#for (K, 0, 8)
    object { Tile pigment { rgb 1 } normal { tiling 3*K + 2 0.5 rotate -90*x scale 0.24 } Place(27 + K) }
    object { Tile texture { tiling 3*K + 3 texture_map { [0 Red] [0.5 Stripes] [1 Red] } rotate -90*x scale 0.22 turbulence 0.1 } Place(36 + K) }
    object {
        Tile
        pigment { tiling 3*K + 1 pigment_map { [0 rgb 1] [1 checker scale 0.3] } frequency 2 sine_wave rotate <-70, 20, 0> scale 0.3 }
        Place(45 + K)
    }
#end
