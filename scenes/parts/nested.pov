// Differences in differences, whose faces lie in one plane.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { perspective location <5, 5, -7> look_at <0, 0, 0> angle 30 }
light_source { <-20, 40, -30>, rgb 0.9 }
light_source { <30, 10, -20>, rgb 0.35 shadowless }
background { rgb 0.85 }
#declare Paint = texture { pigment { rgb <0.7, 0.7, 0.72> } finish { ambient 0.1 diffuse 0.9 } }

#declare Nested = difference {
  box { -1.5, 1.5 }
  difference {
    box { <-1, -1.5, -1.5>, <1, 1.5, 1.5> }        // faces in the faces of the block
    difference {
      box { <-0.6, -1.5, -1>, <0.6, 1.5, 1> }      // in those again
      cylinder { <0, -1.5, 0>, <0, 1.5, 0>, 0.35 }
    }
  }
  box { <-1.5, 0.5, -0.5>, <1.5, 1.5, 0.5> }
}
object { Nested texture { Paint } }
