// The accuracy of normals is held in single precision: where a pattern is rough, the last digit decides.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-1, 2, -5> look_at <0, 0.4, 0> angle 35 }
light_source { <10, 50, -30>, 1 }
plane {
    -z, 0
    pigment { rgb <1, 0.8, 0.5> }
    normal { magnet 1 mandel 50 0.2 interior 1, 200 accuracy 0.0005 }
    finish { specular 0.5 }
    translate <-1.9, -1, 0>
    scale 2
}
plane {
    y, -0.5
    pigment { rgb 0.6 }
    normal { julia <-0.5, 0.5>, 10 interior 4, 1 }
    scale 0.5
}
