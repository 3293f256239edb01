// Octahedron, rhombic dodecahedron and truncated cube from half-spaces, in loops over the signs.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.6, -7> look_at <0, 0, 0> angle 56 }
light_source { <-4, 8, -6> rgb 1 }
background { rgb <0.85, 0.87, 0.9> }

#declare Octahedron = intersection {
  #for (I, -1, 1, 2) #for (J, -1, 1, 2) #for (K, -1, 1, 2)
    plane { <I, J, K>, 0.6 }
  #end #end #end
}
#declare RhombicDodecahedron = intersection {
  #for (I, -1, 1, 2) #for (J, -1, 1, 2)
    plane { <I, J, 0>, 0.75 }
    plane { <I, 0, J>, 0.75 }
    plane { <0, I, J>, 0.75 }
  #end #end
}
object { Octahedron pigment { rgb <0.8, 0.3, 0.3> } rotate <10, 30, 0> translate -2.2*x }
object { RhombicDodecahedron pigment { rgb <0.35, 0.6, 0.4> } rotate <0, 20, 15> }
intersection {
  box { -0.85, 0.85 pigment { rgb <0.3, 0.4, 0.75> } }
  object { Octahedron scale 2 pigment { rgb <0.95, 0.8, 0.3> } }
  rotate <-10, 35, 0>
  translate 2.2*x
}
