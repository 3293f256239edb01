// Pavements of squares, triangles and hexagons with every exterior, interior and form.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> right 9.2*x up 6.9*y direction z }
background { rgb 0.1 }

#declare Map = color_map { [0 rgb <0.9, 0.9, 0.7>] [0.5 rgb <0.2, 0.6, 0.3>] [0.8 rgb <0.1, 0.2, 0.6>] [1 rgb <0.8, 0.1, 0.1>] }
#declare Most = array[3][6] { { 1, 1, 1, 3, 4, 12 }, { 1, 1, 2, 5, 12, 35 }, { 1, 1, 3, 7, 22, 22 } }
#declare K = 0;
#for (Round, 0, 2)
    #for (Kind, 0, 2)
        #declare Sides = select(Kind - 1, 3, 4, 6);
        #for (Tiles, 1, 6)
            #declare Used = select(Kind - 1, Tiles, Tiles, min(Tiles, 5));
            #declare Shown = 1 + mod(Round*5 + Tiles, Most[Kind][Used - 1]);
            box {
                <-0.48, -0.48, 0>, <0.48, 0.48, 0.1>
                pigment {
                    pavement number_of_sides Sides number_of_tiles Used pattern Shown
                    exterior select(Kind - 1, mod(K, 3), mod(K, 3), 0) interior mod(K + Round, 3) form mod(K + Tiles, select(Kind - 1, 3, 4, 3))
                    color_map { Map } rotate -90*x scale 0.15
                }
                finish { ambient 1 diffuse 0 }
                translate <mod(K, 9) - 4, 2.9 - div(K, 9)*1.12, 0>
            }
            #declare K = K + 1;
        #end
    #end
#end
