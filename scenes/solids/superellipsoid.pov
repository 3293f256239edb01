// Superellipsoids: round, square, pinched and pointed, and as operands.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0.4, 5, -9> look_at <0, 0.1, 0> angle 46 }
light_source { <-4, 9, -8> rgb 1 }
background { rgb 0.3 }
#declare Soft = superellipsoid { <0.3, 0.3> rotate 15*x }
superellipsoid { <1.5, 0.5> rotate -60*x pigment { rgb <0.9, 0.6, 0.2> } translate <-2.8, 0, 1.6> }
superellipsoid { <0.1, 0.1> rotate 30*y scale <1, 0.6, 1> pigment { rgb <0.3, 0.6, 0.9> } translate <0, 0, 1.8> }
superellipsoid { <1, 2.6> rotate -70*x scale 1.2 pigment { rgb <0.5, 0.8, 0.3> } translate <2.8, 0, 1.6> }
superellipsoid { <2.4, 2.4> rotate <20, 30, 0> scale 1.1 pigment { rgb <0.9, 0.3, 0.4> } translate <-1.2, 0, -0.2> }
superellipsoid { <2.5, 0.6> rotate <-50, 20, 0> scale 0.7 pigment { rgb <0.7, 0.6, 0.9> } translate <1.4, 0, -0.2> }
difference { object { Soft } sphere { <0.6, 0.8, -0.6>, 0.8 } pigment { rgb <0.8, 0.7, 0.5> } scale 0.7 translate <-2.6, 0, -1.8> }
intersection { sphere { 0, 1.1 } object { Soft inverse } pigment { rgb <0.4, 0.8, 0.7> } scale 0.8 translate <0, 0, -2.4> }
object { Soft clipped_by { plane { <0.4, 1, 0>, 0.2 } } pigment { rgb <0.9, 0.5, 0.3> } scale 0.7 translate <2.6, 0, -1.8> }
