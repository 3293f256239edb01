// A flange: a hub on a disc with eight bolt holes and a bore.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { perspective location <7, 8, -10> look_at <0, 0.4, 0> angle 30 }
light_source { <-20, 40, -30>, rgb 0.9 }
light_source { <30, 10, -20>, rgb 0.35 shadowless }
background { rgb 0.85 }
#declare Paint = texture { pigment { rgb <0.55, 0.6, 0.7> } finish { ambient 0.1 diffuse 0.9 } }

#declare Flange = difference {
  union {
    cylinder { <0, 0, 0>, <0, 0.5, 0>, 3 }
    cone { <0, 0.5, 0>, 1.6, <0, 1.5, 0>, 1.2 }
  }
  cylinder { <0, -1, 0>, <0, 2, 0>, 0.8 }
  cylinder { <0, 1.25, 0>, <0, 2, 0>, 0.95 }
  #for (I, 0, 7)
    cylinder { <2.3, -1, 0>, <2.3, 1, 0>, 0.3 rotate 45 * I * y }
  #end
}
object { Flange texture { Paint } }
