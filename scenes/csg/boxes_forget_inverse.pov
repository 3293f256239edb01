// POV-Ray shows nothing of a CSG object beyond its box. Height fields do not make that box smaller; patches, polygons and julia fractals do, even
// turned inside out or subtracted.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4.2, -9> look_at <0, 0.1, 0> angle 45 }
light_source { <-6, 9, -8>, 1 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, -1.5 pigment { checker rgb 0.8 rgb 0.4 } }
#declare Julia = julia_fractal { <-0.1, 0.15, 0, 0> quaternion sqr max_iteration 6 precision 40 pigment { rgb <0.9, 0.6, 0.2> } }
#declare Block = box { <-2.2, -0.4, -0.4>, <0.5, 0.6, 0.4> pigment { rgb <0.25, 0.35, 0.9> } }

difference { object { Block } object { Julia scale 0.5 } translate <-1.6, 0, 1.4> }
intersection { object { Block } object { Julia scale 0.5 inverse } translate <1.2, 0, 1.4> }
difference {
  height_field { function 20, 20 { 0.3*x*y } translate <-0.5, -0.4, -0.5> clipped_by { sphere { <0.1, -0.1, 0>, 0.35 } } }
  sphere { <0.1, 0.1, 0.1>, 0.6 pigment { rgb <0.7, 0.5, 0.9> } }
  pigment { rgb <0.2, 0.9, 0.7> }
  inverse
  translate 3*x
}
difference { box { -0.6, 0.6 } polygon { 4, <-0.4, -0.3>, <0.5, -0.3>, <0, 0.5>, <-0.4, -0.3> } pigment { rgb <0.9, 0.4, 0.4> } translate <-2.8, 0, -1> }
difference { box { -0.6, 0.6 } triangle { <-0.4, -0.3, -1>, <0.5, -0.3, 0>, <0, 0.5, 1> } pigment { rgb <0.4, 0.8, 0.4> } translate <-1, 0, -1> }
intersection {
  box { -0.6, 0.6 }
  bicubic_patch {
    type 1 flatness 0.01 u_steps 3 v_steps 3
    <-0.5, 0, -0.5>, <-0.2, 0, -0.5>, <0.2, 0, -0.5>, <0.5, 0, -0.5>, <-0.5, 0, -0.2>, <-0.2, 0.6, -0.2>, <0.2, 0.6, -0.2>, <0.5, 0, -0.2>,
    <-0.5, 0, 0.2>, <-0.2, 0.6, 0.2>, <0.2, 0.6, 0.2>, <0.5, 0, 0.2>, <-0.5, 0, 0.5>, <-0.2, 0, 0.5>, <0.2, 0, 0.5>, <0.5, 0, 0.5>
    inverse
  }
  pigment { rgb <0.9, 0.8, 0.3> }
  translate <0.8, 0, -1>
}
