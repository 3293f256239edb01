// The camera stands inside of solids that reach beyond the boxes that POV-Ray gives them: it is inside of none of them there. The
// glass would bend light otherwise, and the fog would be gone.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at 0 angle 40 }
light_source { <-5, 9, -5> 1 }
background { rgb <0.3, 0.5, 0.8> }
fog { distance 30 rgb <0.9, 0.6, 0.8> }
plane { y, -1.5 pigment { checker rgb 1 rgb 0.3 } hollow }

#declare Dense = interior { ior 1.5 }
disc { <2, 0, 3>, z, 0.5 pigment { rgb x } interior { Dense } }
sphere { <1.5, 0, 0>, 0.3 inverse pigment { rgb <0.4, 0.8, 0.5> } interior { Dense } }
merge { sphere { <-1.6, 0, 0>, 0.3 inverse } sphere { <-1.6, 0.4, 0>, 0.3 } pigment { rgb <0.8, 0.8, 0.4> } interior { Dense } }
intersection { plane { -z, 9 } plane { z, 0 } bounded_by { sphere { <0.3, -1.2, 0>, 0.2 } } pigment { rgb <0.5, 0.4, 0.9> } interior { Dense } }
sphere { 0, 1 pigment { rgbf 0.9 } interior { ior 1.3 } hollow }
