// Letters that stand out of a plate with round corners.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { perspective location <1, 3.5, -11> look_at <0, 0.1, 0> angle 30 }
light_source { <-20, 40, -30>, rgb 0.9 }
light_source { <30, 10, -20>, rgb 0.35 shadowless }
background { rgb 0.85 }
#declare Paint = texture { pigment { rgb <0.75, 0.4, 0.3> } finish { ambient 0.1 diffuse 0.9 } }

#declare Relief = union {
  intersection {
    box { <-3.2, -1.1, 0>, <3.2, 1.2, 0.5> }
    superellipsoid { <0.15, 0.15> scale <3.2, 1.15, 2> translate 0.05 * y }
  }
  text { ttf "crystal.ttf" "Part 7" 0.4, 0 scale <1.9, 1.7, 1> translate <-2.75, -0.55, -0.2> }
}
object { Relief texture { Paint } }
