#version 3.8;
// A mesh camera: each pixel has a face of its own, the last row too. The faces lie on a ball and look outwards.
global_settings { assumed_gamma 1 }
#declare Across = image_width; #declare Down = image_height;
#macro OnBall(A, B) <sin(A)*cos(B), sin(B), -cos(A)*cos(B)> #end
#macro Corner(I, J, R) (R*OnBall((I/Across - 0.5)*2, (0.5 - J/Down)*1.5)) #end
camera {
  mesh_camera { 1 0
    mesh {
      #for (J, 0, Down - 1) #for (I, 0, Across - 1)
        triangle { Corner(I, J, 0.2), Corner(I + 1, J, 0.2), Corner(I + 0.5, J + 1, 0.2) }
      #end #end
    }
  }
  direction -z
}
light_source { <-4, 8, -3>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9 rgb 0.3 } finish { ambient 0.1 diffuse 0.7 } }
sphere { <0, 0, -3>, 0.9 pigment { rgb <0.9, 0.5, 0.3> } finish { ambient 0.1 diffuse 0.7 } }
box { <-3, -1, -3>, <-2, 0.5, -2> pigment { gradient y color_map { [0 rgb x] [1 rgb y] } } finish { ambient 0.2 diffuse 0.7 } }
background { rgb <0.2, 0.3, 0.5> }
