// POV-Ray asks the objects of its hierarchy in the order in which a ray comes to their boxes, and stops at boxes beyond the nearest hit. What is
// drawn outside of its own box is hidden by what lies between it and the box: the floor before the left object, the ball before the right one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 2.6, -7> look_at <0, -0.2, 0> angle 40 }
light_source { <-5, 9, -8> rgb 1 shadowless }
background { rgb <0.3, 0.5, 0.8> }
#default { finish { ambient 0.5 diffuse 0.5 } }
plane { y, -0.7 pigment { checker rgb 0.9 rgb 0.6 } }
merge {
  plane { <-0.3, 0.5, -0.8>, 0.2 clipped_by { sphere { 0, 0.9 inverse } } translate -1.5*x }
  pigment { rgb <0.9, 0.8, 0.2> }
}
sphere { <1.5, 0.2, 0>, 0.85 pigment { rgbf <0.4, 0.9, 0.4, 0.4> } }
intersection {
  union { cylinder { <1.3, -0.5, -0.4>, <2, 0.5, 0.5>, 0.3 inverse } }
  box { <1, -0.45, -0.8>, <2.2, 1.1, 0.5> }
  pigment { rgb <0.8, 0.4, 0.3> }
}
