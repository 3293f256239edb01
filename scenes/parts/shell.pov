// A thin shell: a ball of wall 0.06 with windows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { perspective location <4, 5, -8> look_at <0, 0, 0> angle 30 }
light_source { <-20, 40, -30>, rgb 0.9 }
light_source { <30, 10, -20>, rgb 0.35 shadowless }
background { rgb 0.85 }
#declare Paint = texture { pigment { rgb <0.85, 0.8, 0.6> } finish { ambient 0.1 diffuse 0.9 } }

#declare Shell = difference {
  sphere { 0, 2 }
  sphere { 0, 1.94 }
  #for (I, 0, 2) cylinder { <0, 0, -3>, <0, 0, 3>, 0.8 rotate 60 * I * y } #end
  cylinder { <0, 1, 0>, <0, 3, 0>, 1 }
}
object { Shell texture { Paint } }
