// A transformation after the texture carries it along; one before it leaves the pattern in place.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2.4, -6> look_at <0, 0.1, 0> angle 52 }
light_source { <3, 6, -6> rgb 1 }
background { rgb <0.2, 0.2, 0.2> }

#declare Checks = texture { pigment { checker rgb <0.9, 0.9, 0.8>, rgb <0.2, 0.4, 0.6> scale 0.4 } }
box { -0.7, 0.7 texture { Checks } rotate <20, 35, 0> translate -2*x }
box { -0.7, 0.7 rotate <20, 35, 0> texture { Checks } }
box { -0.7, 0.7 texture { Checks rotate 45*z scale 0.5 } rotate <20, 35, 0> translate 2*x }
