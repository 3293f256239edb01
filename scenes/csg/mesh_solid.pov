// A closed mesh with an inside_vector is a solid: subtracted from and subtracting.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.5, 2.4, -5> look_at 0 angle 50 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.2, 0.22, 0.2> }

#declare Octa = mesh {
  #for (I, -1, 1, 2) #for (J, -1, 1, 2) #for (K, -1, 1, 2)
    triangle { I*x, J*y, K*z }
  #end #end #end
  inside_vector <0.3, 1, 0.2>
}
difference {
  object { Octa pigment { rgb <0.85, 0.5, 0.25> } }
  cylinder { -2*z, 2*z, 0.35 pigment { rgb <0.9, 0.85, 0.6> } }
  rotate 25*y
  translate -1.2*x
}
difference {
  box { -0.8, 0.8 pigment { rgb <0.35, 0.5, 0.7> } }
  object { Octa scale 0.9 translate <0, 0.6, -0.6> pigment { rgb <0.8, 0.8, 0.85> } }
  rotate -20*y
  translate 1.2*x
}
