// A hyperbolic paraboloid (mixed terms, unbounded on both sides) as operand.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <2.2, 2.6, -4> look_at <0, -0.2, 0> angle 46 }
light_source { <5, 6, -3> rgb 1 }
background { rgb <0.2, 0.25, 0.3> }

intersection {
  quadric { <0, 0, 0>, <0, 0.9, 0>, <0, 1, 0>, 0 pigment { rgb <0.9, 0.6, 0.25> } }
  cylinder { -1.4*y, 1.4*y, 1.2 pigment { rgb <0.4, 0.45, 0.6> } }
  finish { phong 0.5 phong_size 30 }
}
