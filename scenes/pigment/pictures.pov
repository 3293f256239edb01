// Pictures as pigments, normals, patterns and choosers of textures: every projection and interpolation, palettes, alpha.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0.6, -9> look_at 0 angle 40 }
light_source { <-6, 8, -8> rgb 1 }
background { rgb <0.5, 0.55, 0.65> }

#default { finish { ambient 0.2 diffuse 0.7 } }

// Behind all: a palette, repeated and moved.
plane { -z, -2 pigment { image_map { png "weave.png" } scale 1.5 rotate 15*z translate <0.3, 0.2, 0> } }

// Planar, once, with its own alpha, over a second layer that mirrors a little.
box {
    <-1, -1, -0.05>, <1, 1, 0.05>
    texture { pigment { rgb <0.9, 0.85, 0.8> } finish { reflection 0.1 } }
    texture { pigment { image_map { png "leaf.png" once interpolate 2 } translate -0.5 scale 1.6 } finish { phong 0.5 } }
    rotate 20*y translate <-2.2, 1, 0>
}
sphere { 0, 0.9 pigment { image_map { png "weave.png" map_type 1 interpolate 4 } } rotate <20, 50, 0> translate <0, 1.1, 0> }
cylinder { -0.9*y, 0.9*y, 0.6 pigment { image_map { png "waves.png" map_type 2 interpolate 3 } scale <1, 1.8, 1> translate -0.9*y } translate <1.9, 1.1, 0> }
torus { 0.7, 0.3 pigment { image_map { png "weave.png" map_type 5 } scale 0.7 } rotate -60*x translate <-2.1, -1.2, 0> }
sphere {
    0, 0.8 pigment { rgb <0.9, 0.5, 0.3> }
    normal { bump_map { png "waves.png" map_type 1 interpolate 2 bump_size 6 } }
    finish { specular 0.4 } translate <-0.1, -1.2, 0>
}
box {
    -0.7, 0.7
    texture {
        material_map {
            png "weave.png" interpolate 2
            texture { pigment { rgb <0.8, 0.1, 0.1> } }
            texture { pigment { granite scale 0.3 } }
            texture { pigment { rgb <0.1, 0.2, 0.7> } finish { phong 1 } }
            texture { pigment { checker rgb 1, rgb 0.3 scale 0.1 } }
        }
    }
    rotate <15, 30, 0> translate <1.6, -1.2, 0>
}
sphere { 0, 0.5 pigment { image_pattern { png "waves.png" interpolate 2 } color_map { [0 rgb <0, 0, 0.4>] [1 rgb <1, 1, 0.6>] } scale 0.6 } translate <2.9, -0.6, -0.5> }
sphere { 0, 0.5 pigment { image_map { function 16, 16 { x*(1 - y) } } translate -0.5 } translate <2.9, 0.7, -0.5> }
disc { 0, z, 0.6 pigment { image_map { png "weave.png" filter 1, 0.7 transmit 3, 0.8 } scale 0.5 } translate <3, -1.7, -0.5> }
