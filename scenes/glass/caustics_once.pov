// Outside of a picture that stands `once`, light passes unfiltered but with its caustics.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -5> look_at 0 angle 50 }
light_source { <-5, 9, -5> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, -1.5 pigment { checker rgb 1, rgb 0.3 } }
box {
    <-1, -1, -0.1>, <1, 1, 0>
    pigment { image_map { png "../pigment/leaf.png" once filter all 0.7 } translate <-0.5, -0.5, 0> scale 1.5 }
    normal { bumps 0.5 scale 0.2 } rotate 60*x interior { caustics 0.2 }
}
