// A quaternion julia set, cut to a slab and put on a foot.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { perspective location <2.5, 3, -6> look_at <0, 0.1, 0> angle 30 }
light_source { <-20, 40, -30>, rgb 0.9 }
light_source { <30, 10, -20>, rgb 0.35 shadowless }
background { rgb 0.85 }
#declare Paint = texture { pigment { rgb <0.55, 0.45, 0.75> } finish { ambient 0.1 diffuse 0.9 } }

#declare Fractal = union {
  julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 5 precision 200 }
  cylinder { <0, -1.3, 0>, <0, -0.7, 0>, 0.6 }
}
object { Fractal texture { Paint } }
