// A mesh camera with four meshes, whose rays are averaged in each pixel; the last mesh has rays in the upper half alone.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Wide = 4/image_width;
#macro Sheet(Dx, Dy, Rows)
    mesh {
        #for (R, 0, Rows - 1)
            #for (C, 0, image_width - 1)
                #local X = -2 + C*Wide + Dx;  #local Y = 1.5 - R*Wide + Dy;
                triangle { <X, Y, -8>, <X + Wide, Y + Wide, -8>, <X + Wide, Y, -8> }
            #end
        #end
    }
#end
camera {
    mesh_camera {
        4 0
        Sheet(0, 0, image_height) Sheet(0.5*Wide, 0, image_height) Sheet(0, 0.5*Wide, image_height) Sheet(0.2, 0.1, image_height/2)
    }
}
light_source { <-6, 9, -9> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
sphere { <-0.6, 0.2, 0>, 0.9 pigment { checker rgb 1, rgb <0.2, 0.4, 0.2> scale 0.3 } }
box { <0.2, -1.2, 0>, <1.6, 0.3, 1> pigment { rgb <0.9, 0.4, 0.2> } rotate 20*z }
