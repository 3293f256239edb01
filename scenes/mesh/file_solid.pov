// A closed mesh of an STL file is a solid without an inside_vector: POV-Ray has the same shape made of boxes.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <3, 5, -7> look_at <1, 1, 0.8> angle 40 }
light_source { <-3, 6, -5> rgb 1 }
background { rgb <0.2, 0.22, 0.2> }

#ifdef (Whittle)
  #declare Angle = mesh { file "angle.stl" }
#else
  #declare Angle = union { box { 0, <3, 1, 2> } box { <0, 1, 0>, <1, 3, 2> } }
#end
difference {
  object { Angle pigment { rgb <0.85, 0.5, 0.25> } }
  cylinder { <2, -1, 1>, <2, 2, 1>, 0.6 pigment { rgb <0.9, 0.85, 0.6> } }
  cylinder { <-1, 2, 1>, <2, 2, 1>, 0.5 pigment { rgb <0.9, 0.85, 0.6> } }
}
// The other way round, turned and scaled.
difference {
  sphere { 0, 1 }
  object { Angle scale <0.3, 0.4, 0.5> rotate <20, 30, 40> translate <-0.3, -0.2, -0.9> }
  pigment { rgb <0.35, 0.5, 0.7> }
  translate <-1.2, 1, 0>
}
