// Four hundred julia fractals of quaternions, each with its own parameter.
// bench: +W480 +H360 -A
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 14, -22> look_at <0, -1.5, 0> angle 44 }
light_source { <-20, 30, -25> rgb 1 }
background { rgb <0.15, 0.18, 0.25> }
plane { y, -0.7 pigment { checker rgb 0.75, rgb 0.55 } }
#declare S = seed(5);
#for (I, 0, 399)
  julia_fractal {
    <-0.10 - 0.2*rand(S), 0.5 + 0.2*rand(S), -0.2 + 0.2*rand(S), -0.3 + 0.3*rand(S)>
    quaternion sqr
    max_iteration 7
    precision 25
    scale 0.45
    rotate 360*rand(S)*y
    translate <mod(I, 20) - 9.5, 0, int(I/20) - 9.5>
    pigment { rgb <0.4 + 0.5*rand(S), 0.35 + 0.4*rand(S), 0.3 + 0.4*rand(S)> }
  }
#end
