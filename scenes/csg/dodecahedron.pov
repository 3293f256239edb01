// A regular dodecahedron of twelve half-spaces, its faces placed by rotation, with a ball inside shown by windows.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.6, -4.4> look_at 0 angle 42 }
light_source { <-3, 5, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Tilt = degrees(atan2(2, 1));    // between neighbouring faces' normals
#declare Dodecahedron = intersection {
  plane { y, 1 }
  plane { -y, 1 }
  #declare I = 0;
  #while (I < 5)
    plane { y, 1 rotate Tilt*x rotate 72*I*y }
    plane { -y, 1 rotate Tilt*x rotate (72*I + 36)*y }
    #declare I = I + 1;
  #end
}
difference {
  object { Dodecahedron pigment { rgb <0.9, 0.75, 0.4> } }
  sphere { 0, 1.12 pigment { rgb <0.5, 0.2, 0.15> } }
}
sphere { 0, 0.8 pigment { rgb <0.4, 0.7, 0.9> } finish { phong 0.8 } }
