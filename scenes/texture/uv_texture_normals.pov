// `texture { uv_mapping ... }`: what moves the object leaves the points alone but moves the normals.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -12> look_at 0 angle 40 }
light_source { <-20, 30, -40> rgb 1 }
background { rgb <0.2, 0.25, 0.3> }

#declare Worn = texture { pigment { rgb 0.9 } normal { wrinkles 0.8 scale 0.2 } finish { phong 0.4 } }
#declare Wavy = texture { pigment { rgb <0.9, 0.6, 0.3> } normal { gradient x 0.6 sine_wave scale 0.05 } }

box { -1, 1 texture { uv_mapping Worn } rotate <20, 35, 0> translate <-3.6, 1.5, 0> }
sphere { 0, 1 texture { uv_mapping Wavy } scale <1.3, 0.8, 0.5> translate <-1, 1.5, 0> }
sphere { 0, 1.1 texture { uv_mapping checker texture { Worn } texture { Wavy } scale 0.1 } rotate <40, 20, 70> translate <1.6, 1.5, 0> }
merge { box { -0.8, 0.8 texture { uv_mapping Worn } } matrix <1, -0.1, 0, 0.3, 1, -0.2, 0, 0.4, 1, 0, 0, 0> translate <4, 1.5, 0> }
torus { 0.8, 0.4 uv_mapping texture { Worn } rotate -60*x translate <-3.6, -1.5, 0> }
sphere { 0, 1.1 texture { gradient y texture_map { [0 uv_mapping Worn] [1 Wavy] } scale 1.2 rotate 20*z } rotate 60*y translate <-1, -1.5, 0> }
mesh {
  triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> uv_vectors <0, 0>, <1, 0>, <0.5, 1> }
  texture { uv_mapping Wavy }
  rotate <30, 20, 50> translate <1.6, -1.5, 0>
}
cylinder { <0, -1, 0>, <0, 1, 0>, 0.8 texture { uv_mapping Worn scale 2 } rotate 30*z translate <4, -1.5, 0> }
