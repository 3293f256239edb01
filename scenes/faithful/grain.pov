// --faithful on one thread: crand draws POV-Ray's random numbers in POV-Ray's order, one for each light of each layer that is lit.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -8> look_at <0, 0.6, 0> angle 40 }
background { rgb <0.3, 0.4, 0.6> }
light_source { <-6, 9, -6> rgb 0.8 }
light_source { <6, 5, -6> rgb 0.4 }

plane { y, 0 pigment { checker rgb 0.9 rgb <0.5, 0.4, 0.3> } finish { crand 0.2 } }
sphere { <-1.6, 1, 0>, 1 pigment { rgb <0.8, 0.3, 0.2> } finish { crand 0.4 diffuse 0.9 specular 0.4 } }
sphere {
  <0.9, 1, -0.5>, 1
  texture { pigment { rgb <0.3, 0.6, 0.3> } finish { crand 0.5 } }
  texture { pigment { bozo color_map { [0.4 rgbt <1, 1, 1, 1>] [0.6 rgbt <1, 0.9, 0.5, 0.3>] } scale 0.4 } finish { crand 0.3 } }
}
box {
  <-0.6, 0, -2.6>, <0.4, 0.6, -1.8>
  texture {
    gradient x
    texture_map {
      [0.3 pigment { rgb <0.2, 0.4, 0.9> } finish { crand 0.6 }]
      [0.7 pigment { rgb <0.9, 0.8, 0.2> } finish { crand 0.1 }]
    }
  }
  rotate 20*y
}
