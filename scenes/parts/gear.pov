// A spur gear of sixteen teeth, with a keyway.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { perspective location <5, 9, -9> look_at <0, 0, 0> angle 30 }
light_source { <-20, 40, -30>, rgb 0.9 }
light_source { <30, 10, -20>, rgb 0.35 shadowless }
background { rgb 0.85 }
#declare Paint = texture { pigment { rgb <0.8, 0.65, 0.3> } finish { ambient 0.1 diffuse 0.9 } }

#declare Tooth = prism { linear_spline -0.5, 0.5, 5, <2.2, -0.34>, <3, -0.16>, <3, 0.16>, <2.2, 0.34>, <2.2, -0.34> }
#declare Gear = difference {
  union {
    cylinder { <0, -0.5, 0>, <0, 0.5, 0>, 2.3 }
    #for (I, 0, 15) object { Tooth rotate 22.5 * I * y } #end
    cylinder { <0, -0.9, 0>, <0, 0.9, 0>, 1 }
  }
  cylinder { <0, -1, 0>, <0, 1, 0>, 0.6 }
  box { <-0.15, -1, 0>, <0.15, 1, 0.8> }
}
object { Gear texture { Paint } }
