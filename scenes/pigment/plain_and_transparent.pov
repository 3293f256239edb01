// Plain colours, filter against transmit, and black and white glass before stripes.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -6> look_at <0, 0.6, 0> angle 46 }
light_source { <-3, 6, -6> rgb 1 }

plane { -z, -2 pigment { gradient x color_map { [0.5 rgb <0.9, 0.85, 0.7>] [0.5 rgb <0.2, 0.3, 0.5>] } scale 0.6 } }
#macro Ball(I, Paint) sphere { <-2 + I, 0.6, 0>, 0.48 pigment { Paint } } #end
Ball(0, rgb <0.9, 0.4, 0.3>)
Ball(1, rgbf <0.9, 0.4, 0.3, 0.8>)
Ball(2, rgbt <0.9, 0.4, 0.3, 0.8>)
Ball(3, rgbft <0.9, 0.8, 0.3, 0.4, 0.4>)
Ball(4, rgbt <0, 0, 0, 0.7>)
