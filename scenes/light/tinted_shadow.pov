// Light through coloured glass: filter tints the shadow, transmit only thins it, two panes multiply.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 4.5, -6> look_at <0, 0, 0.5> angle 50 }
light_source { <0, 8, -4> rgb 1 }

#macro Pane(X, Paint) box { <X - 0.7, 1.0, -0.8>, <X + 0.7, 1.05, 0.6> pigment { Paint } } #end
Pane(-1.8, rgbf <0.9, 0.3, 0.2, 0.8>)
Pane(0, rgbt <0.2, 0.7, 0.3, 0.6>)
Pane(1.8, rgbft <0.3, 0.4, 0.9, 0.5, 0.3>)
box { <-2.6, 0.5, -0.4>, <2.6, 0.53, -0.1> pigment { rgbf <1, 1, 0.4, 0.9> } }
sphere { <0.9, 0.3, 0.9>, 0.3 pigment { rgb <0.8, 0.6, 0.4> } }
plane { y, 0 pigment { rgb 0.9 } }
