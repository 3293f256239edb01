// Noise before version 3.5 is the first generator, also where it is asked while the text is read: ground of a function, balls
// placed and coloured by one.
#version 3.1;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3.2, -4.5> look_at <0, 0.2, 0> angle 42 }
light_source { <-6, 8, -4> rgb 1 }
background { rgb <0.22, 0.24, 0.3> }

#declare Rough = function { pattern { bozo scale 0.2 } }
#declare Tint = function { pigment { spotted color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.1, 0.8, 0.9>] } scale 0.35 } }

height_field {
  function 60, 60 { Rough(x, y, z) }
  smooth
  translate <-0.5, 0, -0.5> scale <3, 0.7, 3>
  pigment { bozo color_map { [0 rgb <0.2, 0.4, 0.1>] [1 rgb <0.8, 0.7, 0.4>] } scale 0.4 }
}
#declare I = 0;
#while (I < 9)
  sphere {
    <I * 0.3 - 1.2, 0.5 + Rough(I * 0.37, 0.4, 0.8), -0.2>, 0.14
    pigment { rgb <Tint(I * 0.37, 0.1, 0.2).red, Tint(I * 0.37, 0.1, 0.2).green, Tint(I * 0.37, 0.1, 0.2).blue> }
  }
  #declare I = I + 1;
#end
