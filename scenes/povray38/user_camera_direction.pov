#version 3.8;
// Functions give the directions, vectors the place: an equirectangular view that u and v name, and that no rotation turns.
global_settings { assumed_gamma 1 }
camera {
  user_defined
  direction { function { sin(2*pi*u)*cos(pi*v) } function { sin(pi*v) } function { cos(2*pi*u)*cos(pi*v) } }
  location <0.3, 0.2, -0.4>
  rotate 15*z
}
light_source { <1, 4, -3>, rgb 1 }
#declare Look = finish { ambient 0.2 diffuse 0.7 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } finish { Look } }
box { <-6, -1, 5>, <6, 1.5, 5.5> pigment { rgb <0.8, 0.5, 0.3> } finish { Look } }
box { <-6, -1, -5.5>, <6, 1, -5> pigment { rgb <0.3, 0.6, 0.4> } finish { Look } }
sphere { <2.5, 0, 0>, 1 pigment { rgb <0.4, 0.5, 0.9> } finish { Look } }
cylinder { <-2.5, -1, 1>, <-2.5, 2, 1>, 0.4 pigment { rgb <0.9, 0.8, 0.3> } finish { Look } }
background { rgb <0.5, 0.6, 0.8> }
