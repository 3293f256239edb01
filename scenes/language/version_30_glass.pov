// ior in the finish, as scenes before 3.1 wrote it, and filter by name.
#version 3.0;
camera { location <0, 1.5, -5> look_at <0, 0.4, 0> angle 48 }
light_source { <-3, 6, -5> color rgb 1 }

sphere {
  <0, 0.8, 0>, 0.8
  pigment { color red 0.9 green 1 blue 0.9 filter 0.9 }
  finish { ambient 0 diffuse 0.1 refraction 1 ior 1.4 phong 0.8 }
}
box { <-2, 0, 2>, <-1, 1.6, 3> pigment { color rgb <0.8, 0.4, 0.3> } }
box { <0.8, 0, 2>, <1.8, 1.2, 3> pigment { color rgb <0.3, 0.4, 0.8> } }
plane { y, 0 pigment { checker color rgb <0.8, 0.8, 0.8> color rgb <0.3, 0.5, 0.4> } }
