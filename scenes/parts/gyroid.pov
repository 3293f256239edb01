// A gyroid in a ball: the surface where three waves cancel, made thick.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { perspective location <4, 5, -8> look_at <0, 0, 0> angle 30 }
light_source { <-20, 40, -30>, rgb 0.9 }
light_source { <30, 10, -20>, rgb 0.35 shadowless }
background { rgb 0.85 }
#declare Paint = texture { pigment { rgb <0.45, 0.7, 0.45> } finish { ambient 0.1 diffuse 0.9 } }

#declare Gyroid = intersection {
  isosurface {
    function { abs(sin(3 * x) * cos(3 * y) + sin(3 * y) * cos(3 * z) + sin(3 * z) * cos(3 * x)) - 0.45 }
    contained_by { box { -2.05, 2.05 } }
    max_gradient 6
    all_intersections    // the ball cuts it: every crossing counts
  }
  sphere { 0, 2 }
}
object { Gyroid texture { Paint } }
