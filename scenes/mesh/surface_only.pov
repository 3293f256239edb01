// Meshes that bound nothing or not everything: without inside_vector as an operand, and with holes in it.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.3, 2.6, -5.5> look_at <0, 0, 0> angle 46 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.2, 0.22, 0.2> }

#macro Faces(Missing)
  #for (I, -1, 1, 2) #for (J, -1, 1, 2) #for (K, -1, 1, 2)
    #if (!(I = -1 & J = 1 & K = -1 & Missing)) triangle { I*x, J*y, K*z } #end
  #end #end #end
#end
#declare Sheet = mesh { Faces(no) }
#declare Torn = mesh { Faces(yes) inside_vector <0.2, -1, 0.1> }

merge { object { Sheet } sphere { 0.3*x, 0.6 } pigment { rgbt <0.9, 0.6, 0.3, 0.4> } translate -1.6*x }
difference { object { Torn pigment { rgb <0.4, 0.6, 0.8> } } cylinder { -2*z, 2*z, 0.3 pigment { rgb 0.9 } } rotate 15*y }
difference { box { <-0.7, -0.9, -0.2>, <0.7, 0.5, 0.9> pigment { rgb <0.8, 0.7, 0.4> } } object { Torn pigment { rgb <0.7, 0.3, 0.3> } } rotate -25*y translate 1.8*x }
