// Characters of three faces: lit from the side, turned, and cut out of a block.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <2.4, 1.2, -6> look_at <2, 0.4, 0> angle 45 }
light_source { <-4, 8, -10> rgb 1 }
background { rgb 0.3 }
text { ttf "timrom.ttf" "Whittle & AV" 0.4, 0 pigment { rgb <0.8, 0.5, 0.2> } finish { phong 0.6 } translate -0.5*x }
text { ttf "cyrvetic.ttf" "prism \"8\"" 1, 0.05*x pigment { rgb <0.3, 0.6, 0.8> } rotate 10*x translate <0, 1.3, 1> }
difference { box { <-0.5, -1.2, 0>, <5, -0.2, 0.4> } text { ttf "crystal.ttf" "Cut Text" 0.3, 0 translate <0, -1, -0.1> } pigment { rgb <0.5, 0.7, 0.3> } }
