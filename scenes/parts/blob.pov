// A blob of four balls, a rod and a ball that takes away.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { perspective location <4, 5, -9> look_at <0, 0, 0> angle 30 }
light_source { <-20, 40, -30>, rgb 0.9 }
light_source { <30, 10, -20>, rgb 0.35 shadowless }
background { rgb 0.85 }
#declare Paint = texture { pigment { rgb <0.8, 0.45, 0.5> } finish { ambient 0.1 diffuse 0.9 } }

#declare Drop = blob {
  threshold 0.4
  sphere { <-1.1, 0, 0>, 1.5, 1 }
  sphere { <1.1, 0, 0>, 1.5, 1 }
  sphere { <0, 1.3, 0>, 1.3, 1 }
  sphere { <0, -0.8, 0.6>, 1.4, 0.9 }
  cylinder { <0, -0.5, -1.6>, <0, 0.4, 1.2>, 0.8, 0.9 }
  sphere { <0, 0.4, -0.9>, 0.9, -0.8 }
}
object { Drop texture { Paint } }
