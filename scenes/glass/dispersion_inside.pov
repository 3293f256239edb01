// From inside of a block that disperses: what is mirrored within stays white until it gets out.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <0, 0, 0> look_at <0.3, -0.2, 1> angle 90 }
light_source { <-8, 12, -6> rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
plane { y, -2 pigment { checker rgb 0.9, rgb 0.15 scale 0.4 } }
box {
  -1, 1
  rotate <10, 20, 5>
  pigment { rgbf <0.8, 1, 0.9, 0.9> }
  interior { ior 1.6 dispersion 1.15 dispersion_samples 5 }
}
