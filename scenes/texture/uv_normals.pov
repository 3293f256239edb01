// Normals on surface coordinates: bumps, maps and pictures, on turned balls too, whose coordinates turn with them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -12> look_at 0 angle 46 }
light_source { <-20, 30, -40> rgb 1 }
background { rgb <0.2, 0.25, 0.3> }

#declare Grey = pigment { rgb 0.9 }
#declare Fine = normal { uv_mapping bumps 0.8 scale 0.04 }

sphere { <-4.2, 1.7, 0>, 1.3 pigment { Grey } normal { Fine } finish { phong 0.5 } }
sphere { 0, 1.3 pigment { Grey } normal { uv_mapping bump_map { png "../pigment/weave.png" bump_size 2 interpolate 2 } scale 0.3 } rotate <30, 20, 40> translate <-1.4, 1.7, 0> }
torus { 0.9, 0.4 pigment { Grey } normal { gradient y normal_map { [0 Fine] [1 granite 0.4] } scale 0.7 } rotate -60*x translate <1.4, 1.7, 0> }
box { -1, 1 pigment { Grey } normal { average normal_map { [1 uv_mapping gradient x 1 scale 0.05 sine_wave] [1 wrinkles 0.6 scale 0.2] } } rotate <20, 35, 0> translate <4.2, 1.7, 0> }
sphere { 0, 1.3 texture { uv_mapping pigment { checker rgb <0.9, 0.5, 0.2>, rgb 1 scale <0.1, 0.1, 1> } } rotate <50, 20, 30> translate <-4.2, -1.5, 0> }
intersection {
    sphere { 0, 1.3 }
    box { -1.05, 1.05 }
    uv_mapping
    texture { pigment { checker rgb <0.3, 0.6, 0.9>, rgb 1 scale <0.08, 0.08, 1> } normal { bumps 0.5 scale 0.03 } }
    rotate <30, 40, 10>
    translate <-1.4, -1.5, 0>
}
union {
    sphere { 0, 1 scale -1 }
    cylinder { <0, -1.5, 0>, <0, 1.5, 0>, 0.3 }
    texture { uv_mapping pigment { gradient x color_map { [0 rgb <0.9, 0.2, 0.3>] [1 rgb <1, 1, 0.6>] } scale 0.125 } }
    rotate 25*z
    translate <1.4, -1.5, 0>
}
cylinder { <0, -1.3, 0>, <0, 1.3, 0>, 0.9 texture { gradient x texture_map { [0 pigment { Grey } normal { Fine }] [1 pigment { rgb <0.2, 0.6, 0.3> }] } scale 0.6 } rotate 20*x translate <4.2, -1.5, 0> }
