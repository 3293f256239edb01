// Transformed unions inside transformed unions: an arm of three joints.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.8, 2.2, -6> look_at <0.8, 1.2, 0> angle 46 }
light_source { <-3, 7, -6> rgb 1 }
background { rgb <0.55, 0.6, 0.65> }

#declare Link = union {
  sphere { 0, 0.25 }
  cylinder { 0, 1.2*y, 0.14 }
}
union {
  object { Link pigment { rgb <0.8, 0.3, 0.25> } }
  union {
    object { Link pigment { rgb <0.9, 0.75, 0.3> } }
    union {
      object { Link pigment { rgb <0.3, 0.5, 0.8> } }
      sphere { 1.3*y, 0.3 pigment { rgb 0.9 } }
      rotate -60*z
      translate 1.2*y
    }
    rotate <20, 0, -40>
    translate 1.2*y
  }
  rotate 15*z
}
plane { y, -0.25 pigment { rgb <0.45, 0.5, 0.45> } }
