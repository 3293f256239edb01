// A tetrahedron as the intersection of four half-spaces, whole and hollowed by a smaller one.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2, -5> look_at <0, 0.1, 0> angle 50 }
light_source { <-2, 5, -6> rgb 1 }
light_source { <6, 2, -2> rgb 0.35 }

#declare Tetrahedron = intersection {
  plane { < 1,  1,  1>, 0.5 }
  plane { <-1, -1,  1>, 0.5 }
  plane { <-1,  1, -1>, 0.5 }
  plane { < 1, -1, -1>, 0.5 }
}
object { Tetrahedron pigment { rgb <0.9, 0.55, 0.2> } rotate <20, 30, 0> translate -1.1*x }
difference {
  object { Tetrahedron pigment { rgb <0.35, 0.6, 0.85> } }
  object { Tetrahedron scale -0.8 pigment { rgb <0.9, 0.85, 0.5> } }
  rotate <-15, 60, 10>
  translate 1.1*x
}
