// Turned pieces on a board, of cones, spheres, quadrics and tori, merged and cut.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <5, 7, -12> look_at <0, 0.3, -0.4> angle 40 }
light_source { <-10, 18, -12> rgb 1 }
light_source { <12, 10, -4> rgb <0.3, 0.3, 0.4> }
background { rgb <0.2, 0.16, 0.13> }

#declare Foot = union {
  difference {
    cylinder { 0, 0.25*y, 0.42 }
    torus { 0.44, 0.08 translate 0.14*y }
  }
  intersection {
    quadric { <1, -0.12, 1>, <0, 0, 0>, <0, 0.16, 0>, -0.06 }
    box { <-0.6, 0.2, -0.6>, <0.6, 0.9, 0.6> }
    bounded_by { box { <-0.6, 0.2, -0.6>, <0.6, 0.9, 0.6> } }
  }
  torus { 0.2, 0.06 translate 0.88*y }
}
#declare Pawn = union { object { Foot } sphere { 1.05*y, 0.22 } }
#declare Rook = union {
  object { Foot }
  difference {
    cylinder { 0.88*y, 1.3*y, 0.3 }
    cylinder { 1.1*y, 1.4*y, 0.2 }
    box { <-0.5, 1.2, -0.07>, <0.5, 1.4, 0.07> }
    box { <-0.07, 1.2, -0.5>, <0.07, 1.4, 0.5> }
  }
}
#declare Bishop = union {
  object { Foot }
  difference {
    sphere { 0, 0.26 scale <1, 1.5, 1> translate 1.2*y }
    box { <-0.03, 0, -0.5>, <0.03, 0.4, 0.5> rotate 35*z translate <0, 1.25, 0> }
  }
  sphere { 1.6*y, 0.07 }
}
#macro Side(Row, Step, Paint)
  #for (I, 0, 7)
    object { Pawn pigment { Paint } finish { phong 0.7 } translate <I - 3.5, 0, Row + Step> }
    object {
      #switch (mod(I, 3)) #case (0) Rook #break #case (1) Bishop #break #else Pawn #end
      pigment { Paint } finish { phong 0.7 } translate <I - 3.5, 0, Row>
    }
  #end
#end
Side(-3.5, 1, rgb <0.9, 0.8, 0.6>)
Side(3.5, -1, rgb <0.3, 0.15, 0.1>)
box { <-4.3, -0.5, -4.3>, <4.3, 0, 4.3> pigment { checker rgb <0.8, 0.7, 0.5>, rgb <0.3, 0.2, 0.15> translate -0.25*y } finish { reflection 0.15 } }
