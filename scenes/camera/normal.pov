// Rays bent by a normal of the camera.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2, -7> look_at <0, 0.6, 0> angle 45 normal { ripples 0.15 scale 0.2 translate <0.3, 0.1, 0> } }
light_source { <-6, 9, -6> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.6> } finish { diffuse 0.7 ambient 0.2 } }
sphere { <-1, 1, 0>, 1 pigment { rgb <0.9, 0.5, 0.3> } finish { phong 0.6 } }
box { <0.5, 0, -1>, <1.8, 1.3, 0.3> pigment { rgb <0.3, 0.7, 0.4> } }
