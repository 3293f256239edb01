// Endless quadrics clipped by a height field, which has no end below: what its box leaves of the quadric decides which rays
// are told of it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -9> look_at <0, 0.2, 0> angle 40 }
light_source { <20, 30, -40> rgb 1 }
background { rgb <0.3, 0.35, 0.4> }
#declare Ground = height_field { png "../solids/height_field.png" translate <-0.5, 0, -0.5> scale <5, 1.6, 5> }
#declare Rings = pigment { checker rgb <0.9, 0.6, 0.3>, rgb <0.4, 0.2, 0.1> scale 0.35 }
quadric { <1, 0, 1>, 0, 0, -0.8 clipped_by { Ground } pigment { Rings } translate -1.9*x }
quadric { <1, -0.3, 1>, 0, 0, -0.2 clipped_by { object { Ground translate 0.3*y } } pigment { Rings } rotate 8*z translate 0.6*x }
quadric { <1, 0, 0.4>, 0, <0, -1, 0>, 0 clipped_by { object { Ground rotate 20*y } } pigment { Rings } translate <2.6, 0.2, 0> }
