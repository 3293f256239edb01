// A bolt: six-sided head, and a thread that is the field of a helix.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { perspective location <6, 5, -9> look_at <0, 1.3, 0> angle 30 }
light_source { <-20, 40, -30>, rgb 0.9 }
light_source { <30, 10, -20>, rgb 0.35 shadowless }
background { rgb 0.85 }
#declare Paint = texture { pigment { rgb <0.6, 0.62, 0.65> } finish { ambient 0.1 diffuse 0.9 } }

// Radius of the thread at a height and an angle: a triangle wave of pitch 0.5.
#declare Pitch = 0.5;
#declare Wave = function (H) { abs(2 * (H - floor(H)) - 1) }
#declare Thread = isosurface {
  function { sqrt(x * x + z * z) - 0.8 - 0.25 * Wave(y / Pitch + atan2(z, x) / (2 * pi)) }
  contained_by { box { <-1.2, 0.2, -1.2>, <1.2, 3.2, 1.2> } }
  max_gradient 2
}
#declare Bolt = union {
  intersection {
    #for (I, 0, 5) plane { x, 1.5 rotate 60 * I * y } #end
    plane { y, 0.3 }
    plane { -y, 0.7 }
    sphere { <0, 1, 0>, 2.35 }
  }
  object { Thread }
}
object { Bolt texture { Paint } }
