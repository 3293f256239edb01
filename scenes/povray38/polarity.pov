#version 3.8;
// Isosurfaces whose inside is above the threshold.
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at 0 angle 44 }
light_source { <4, 8, -6>, rgb 1 }
#declare Look = finish { ambient 0.15 diffuse 0.7 specular 0.3 }
#declare Hills = function { sin(3*x)*sin(3*y)*sin(3*z) + 0.4*x }
isosurface { function { Hills(x, y, z) } threshold 0.1 polarity on max_gradient 5 all_intersections
  contained_by { sphere { 0, 1 } } pigment { rgb <0.9, 0.6, 0.3> } finish { Look } translate -1.2*x }
isosurface { function { Hills(x, y, z) } threshold 0.1 polarity -1 max_gradient 5 all_intersections
  contained_by { sphere { 0, 1 } } pigment { rgb <0.4, 0.6, 0.9> } finish { Look } translate 1.2*x }
difference {
  box { <-0.6, -0.6, -0.5>, <0.6, 0.6, 0.5> }
  isosurface { function { x*x + y*y + z*z } threshold 0.4 polarity 0.5 open max_gradient 4 contained_by { box { -0.9, 0.9 } } }
  pigment { rgb <0.5, 0.8, 0.4> } finish { Look } translate <0, -1, -1.4>
}
