// A right-handed world with z up, as many scenes from CAD have it.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <4, -5, 3> sky z up z right -x*image_width/image_height look_at <0, 0, 0.5> angle 34 }
light_source { <2, -6, 8> rgb 1 }
background { rgb <0.6, 0.7, 0.8> }
box { <-0.5, -0.5, 0>, <0.5, 0.5, 1> pigment { rgb <0.8, 0.5, 0.3> } }
cylinder { <1.2, 0, 0>, <1.2, 0, 0.6>, 0.4 pigment { rgb <0.3, 0.5, 0.8> } }
cone { <0, 1.4, 0>, 0.5, <0, 1.4, 1.3>, 0 pigment { rgb <0.4, 0.7, 0.4> } }
plane { z, 0 pigment { checker rgb 0.8, rgb 0.55 } }
