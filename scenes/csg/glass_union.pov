// A union keeps the surfaces inside its other operands: they show through tinted glass.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 12 }
camera { location <0, 1.5, -5> look_at <0, 0, 0> angle 36 }
light_source { <3, 6, -5> rgb 1 }
background { rgb <0.9, 0.9, 0.85> }

union {
  sphere { <-0.6, 0, 0>, 1 }
  sphere { <0.6, 0, 0>, 1 }
  box { <-0.4, -1.1, -0.4>, <0.4, 1.1, 0.4> }
  pigment { rgbf <0.7, 0.85, 0.95, 0.8> }
  finish { ambient 0.05 diffuse 0.3 phong 0.5 }
}
