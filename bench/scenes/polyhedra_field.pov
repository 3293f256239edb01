// A field of 900 polyhedra: octahedra, rhombic dodecahedra and cut cubes as intersections of half-spaces.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 9, -20> look_at <0, 0, -2> angle 48 }
light_source { <-20, 25, -20> rgb 1 }
background { rgb <0.75, 0.8, 0.85> }

#declare Octahedron = intersection {
  #for (I, -1, 1, 2) #for (J, -1, 1, 2) #for (K, -1, 1, 2)
    plane { <I, J, K>, 0.25 }
  #end #end #end
  bounded_by { sphere { 0, 0.45 } }
}
#declare Dodecahedron = intersection {
  #for (I, -1, 1, 2) #for (J, -1, 1, 2)
    plane { <I, J, 0>, 0.3 }
    plane { <I, 0, J>, 0.3 }
    plane { <0, I, J>, 0.3 }
  #end #end
  bounded_by { sphere { 0, 0.45 } }
}
#declare Cut_cube = intersection { box { -0.33, 0.33 } object { Octahedron scale 1.7 } }

#for (X, 0, 29)
  #for (Z, 0, 29)
    #local Kind = mod(X + 2*Z, 3);
    object {
      #if (Kind = 0) Octahedron #elseif (Kind = 1) Dodecahedron #else Cut_cube #end
      pigment { rgb <0.5 + 0.3*sin(X), 0.5 + 0.3*cos(Z), 0.6> }
      rotate <13*X, 17*Z, 7*(X + Z)>
      translate <(X - 14.5)*0.9, 0.3*sin(X*0.5)*cos(Z*0.5), (Z - 14.5)*0.9>
    }
  #end
#end
plane { y, -1 pigment { rgb 0.6 } }
