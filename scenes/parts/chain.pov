// A chain of five torus links, none touching another.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { perspective location <4, 6, -10> look_at <0, 0, 0> angle 30 }
light_source { <-20, 40, -30>, rgb 0.9 }
light_source { <30, 10, -20>, rgb 0.35 shadowless }
background { rgb 0.85 }
#declare Paint = texture { pigment { rgb <0.7, 0.6, 0.3> } finish { ambient 0.1 diffuse 0.9 } }

#declare Link = torus { 0.8, 0.22 }
#for (I, -2, 2)
  object { Link rotate mod(I + 2, 2) * 90 * x translate 1.1 * I * x texture { Paint pigment { rgb <0.7, 0.6 - 0.1 * I, 0.3 + 0.1 * I> } } }
#end
