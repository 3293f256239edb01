#version 3.8;
// Without `right` a camera of 3.8 has the shape of the picture.
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <-4, 6, -6>, 1 }
sphere { 0, 1 pigment { rgb <0.8, 0.6, 0.3> } }
plane { y, -1 pigment { checker rgb 0.2 rgb 0.9 } }
