#version 3.8;
// Rays by functions: a picture bent about a cylinder, with places left black where no direction is.
global_settings { assumed_gamma 1 }
#declare Wide = function { select(x*x + y*y - 0.22, 1, 0) }
camera {
  user_defined
  location { function { sin(4*x) } function { 2*y } function { -3*cos(2*x) } }
  direction { function { Wide(x, y, 0)*sin(2*x) } function { Wide(x, y, 0)*y }, function { Wide(x, y, 0)*cos(2*x) } }
}
light_source { <4, 8, -6>, rgb 1 }
background { rgb <0.2, 0.3, 0.5> }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } finish { ambient 0.1 diffuse 0.7 } }
sphere { <0, 0, 1>, 0.8 pigment { rgb <0.9, 0.5, 0.3> } finish { ambient 0.1 diffuse 0.7 specular 0.4 } }
torus { 1.6, 0.2 rotate 80*x translate <0, 0.2, 1> pigment { rgb <0.4, 0.7, 0.9> } finish { ambient 0.1 diffuse 0.7 } }
