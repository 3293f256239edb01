// The camera stands inside the hollow of a difference and looks out through its windows.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0, -0.6> look_at <0.2, 0.1, 1> angle 80 }
light_source { <0.4, 0.8, -0.3> rgb 0.9 }
light_source { <5, 8, 20> rgb 0.6 }
background { rgb <0.5, 0.7, 0.9> }

difference {
  box { -1.5, 1.5 pigment { rgb <0.6, 0.6, 0.6> } }
  box { -1.3, 1.3 pigment { rgb <0.9, 0.85, 0.7> } }
  cylinder { <-0.5, 0.2, 0>, <-0.5, 0.2, 3>, 0.4 pigment { rgb <0.8, 0.3, 0.2> } }
  box { <0.3, -0.6, 0>, <1, 0.7, 3> pigment { rgb <0.3, 0.5, 0.3> } }
  sphere { <-1.5, -0.4, 0.6>, 0.4 }
}
sphere { <0, 0.4, 4>, 1.2 pigment { rgb <0.9, 0.7, 0.2> } }
