// One declared mesh shown many times: turned, stretched, mirrored, hidden in unions, each with its own texture.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 5, -9> look_at <0, 0, 0.4> angle 44 }
light_source { <-6, 9, -7> rgb 1 }
plane { y, -1 pigment { rgb <0.6, 0.62, 0.58> } }

#declare N = 16;
#declare Gem = mesh {
  #for (I, 0, N - 1)
    #local A = <cos(2*pi*I/N), 0.3*mod(I, 2), sin(2*pi*I/N)>;
    #local B = <cos(2*pi*(I + 1)/N), 0.3*mod(I + 1, 2), sin(2*pi*(I + 1)/N)>;
    smooth_triangle { A, A*<1, 0, 1> + 0.4*y, B, B*<1, 0, 1> + 0.4*y, 0.9*y, y }
    triangle { A, B, -0.7*y }
  #end
}
#for (I, -3, 3)
  #for (J, -2, 2)
    object {
      Gem
      scale <0.45, 0.3 + 0.1*abs(J), 0.45>
      rotate <10*I, 25*J, 8*I*J>
      #if (mod(I + J, 2) = 0) scale <-1, 1, 1> #end
      translate <1.1*I, -0.4, 1.3*J>
      pigment { rgb <0.5 + 0.15*I, 0.55, 0.5 - 0.2*J> }
      finish { phong 0.3 }
    }
  #end
#end
union {
  object { Gem scale 0.5 }
  object { Gem scale 0.4 rotate 180*z translate 1.6*y }
  pigment { gradient y color_map { [0 rgb <0.9, 0.7, 0.1>][1 rgb <0.1, 0.3, 0.8>] } scale 0.5 }
  translate 0.8*y
}
