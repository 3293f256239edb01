// Intersection of two spheres: a lens, with the texture of each face from its own sphere.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <1.6, 1.2, -3.2> look_at 0 angle 40 }
light_source { <3, 5, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.1> }

intersection {
  sphere { <-0.7, 0, 0>, 1.2 pigment { rgb <0.2, 0.7, 0.5> } }
  sphere { <0.7, 0, 0>, 1.2 pigment { rgb <0.9, 0.5, 0.3> } }
  finish { specular 0.6 roughness 0.02 }
  rotate 75*y
}
