// Infinite surfaces that share their bounds and come before them: what is asked first hides the others, by the hierarchy's order.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.8, -5.6> look_at 0 angle 42 }
background { rgb <0.4, 0.15, 0.16> }
light_source { <2, 7, -8> rgb 1 }
#declare S = seed(11);
#for (I, 1, 20)
  quadric {
    <1, 0.3*mod(I, 3), -0.4 + 0.1*mod(I, 7)>, <0.2, 0, 0.1>, 0, -0.1 - 0.02*I
    pigment { rgb <rand(S), rand(S), rand(S)> }
    rotate 360*<rand(S), rand(S), rand(S)>
    translate 3*<rand(S) - 0.5, rand(S) - 0.5, rand(S) - 0.5>
    bounded_by { #if (mod(I, 4) = 0) box { -0.9, 0.9 } #else sphere { 0, 1.4 } #end }
  }
#end
