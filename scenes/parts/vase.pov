// A vase by lathe: a profile of splines, thin at the lip.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { perspective location <4, 6, -9> look_at <0, 2, 0> angle 30 }
light_source { <-20, 40, -30>, rgb 0.9 }
light_source { <30, 10, -20>, rgb 0.35 shadowless }
background { rgb 0.85 }
#declare Paint = texture { pigment { rgb <0.3, 0.5, 0.75> } finish { ambient 0.1 diffuse 0.9 } }

#declare Vase = lathe {
  cubic_spline 13,
  <0.2, -0.4>, <0, 0>, <1, 0>, <1.25, 0.25>, <1.7, 1.3>, <1.1, 2.8>, <1.25, 3.9>, <1.1, 3.9>, <0.93, 2.8>, <1.5, 1.3>, <0.9, 0.35>, <0, 0.3>, <-0.2, 0.35>
}
object { Vase texture { Paint } }
