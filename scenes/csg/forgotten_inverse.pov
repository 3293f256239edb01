// Julia fractals of POV-Ray 3.7 forget that they are turned inside out: at the end of their own block, and wherever they are
// moved, by themselves or by what holds them. So a difference that is moved afterwards shows what both have in common.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -10> look_at <0, 0.2, 0> angle 36 }
background { rgb <0.55, 0.7, 0.85> }
light_source { <-8, 12, -9> rgb 1 }
plane { y, -1.2 pigment { checker rgb 0.9 rgb 0.6 } }

#declare Smooth = julia_fractal { <-0.1, 0.15, 0, 0> quaternion sqr max_iteration 6 precision 40 pigment { rgb <0.9, 0.6, 0.2> } }
#declare Block = box { <-0.2, -0.9, -0.9>, <1.1, 0.9, 0.9> pigment { rgb <0.25, 0.35, 0.9> } }

// Back row: moved and then cut; cut and then moved; turned, moved and then cut.
difference { object { Block translate <-2.4, 0, 1.6> } object { Smooth translate <-2.4, 0, 1.6> } }
difference { object { Block } object { Smooth } rotate 25*y translate <0, 0, 1.6> }
difference { object { Block translate <2.4, 0, 1.6> } object { Smooth inverse translate <2.4, 0, 1.6> } }

// Front row: turned and then moved; moved and then turned; cut together with a ball, and then moved.
intersection { object { Block translate <-2.4, 0, -1.2> } object { Smooth inverse translate <-2.4, 0, -1.2> } }
intersection { object { Block translate <0, 0, -1.2> } object { Smooth translate <0, 0, -1.2> inverse } }
difference { object { Block } merge { object { Smooth } sphere { <1, 0.9, -0.9>, 0.4 pigment { rgb <0.8, 0.3, 0.3> } } } rotate 25*y translate <2.4, 0, -1.2> }
