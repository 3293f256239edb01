// Focal blur: sharp at the middle row of spheres, with a set of lens places and places beyond it.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera {
    location <0, 2.5, -8> look_at <0, 0.6, 0> angle 40
    aperture 0.7 focal_point <0, 0.7, 0> blur_samples 4, 24 confidence 0.9 variance 1/200
}
light_source { <-6, 9, -6> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.6> } finish { diffuse 0.7 ambient 0.2 } }
#for (Row, -2, 3)
    #for (Column, -2, 2)
        sphere {
            <1.4*Column, 0.6, 2*Row>, 0.6
            pigment { rgb <0.9 - 0.15*abs(Column), 0.4 + 0.1*Row, 0.3> }
            finish { phong 0.6 diffuse 0.7 }
        }
    #end
#end
