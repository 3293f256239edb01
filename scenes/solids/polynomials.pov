// Surfaces of degree 3, 4 and 6: bounded by themselves, by a clip, and cut.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.5, 3.5, -9> look_at <0.4, 0, 0> angle 45 }
light_source { <-5, 8, -10> rgb 1 }
background { rgb 0.3 }
// A ring as a quartic.
quartic {
  <1,0,0,0,2,0,0,2,0,-2.18, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,1.82,0,0,0,0, 1,0,-2.18,0,0.8281>
  pigment { rgb <0.8, 0.5, 0.2> }
  rotate -20*x
  translate <-2.2, 0.6, 0>
}
// A rounded cube.
polynomial { 6, xyz(6,0,0): 1, xyz(0,6,0): 1, xyz(0,0,6): 1, xyz(0,0,0): -1 pigment { rgb <0.3, 0.6, 0.8> } rotate 30*y translate <0.6, 0.6, 1> }
// An open cubic, clipped.
cubic {
  <1,0,0,0, 0,0,0,0,0,-1, 0,0,0,0,0,-1, 1,0,0,0>
  clipped_by { sphere { 0, 1.3 } }
  pigment { rgb <0.5, 0.8, 0.3> }
  translate <2.9, 0.4, 0>
}
difference {
  polynomial { 4, xyz(4,0,0): 1, xyz(0,4,0): 1, xyz(0,0,4): 1, xyz(2,0,0): -1, xyz(0,0,0): -0.3 }
  sphere { <0.5, 0.9, -0.6>, 0.6 }
  pigment { rgb <0.8, 0.3, 0.5> }
  translate <-0.6, -0.6, -2.2>
}
