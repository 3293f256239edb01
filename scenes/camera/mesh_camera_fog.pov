// The rays of a mesh camera start on its faces, all of them in the open, though its location lies inside a sphere: fog shows.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Screen = mesh {
    #for (Row, 0, 59)
        #for (Column, 0, 79)
            #local P = <Column/10 - 4, 3 - Row/10, -7>;
            triangle { P, P + 0.1*x, P - 0.1*y }
        #end
    #end
}
camera { mesh_camera { 1 0 mesh { Screen } } location <0, 0, 0.01> direction z }
light_source { <-5, 9, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
fog { distance 8 rgb <0.9, 0.6, 0.8> }
plane { y, -3.5 pigment { checker rgb 1, rgb 0.3 } }
sphere { 0, 1 pigment { rgb <1, 0.2, 0.2> } }
