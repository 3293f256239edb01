// What profiles make: a vase (lathe), a bottle (sor), a dish (prism), and twigs (sphere_sweep).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#default { finish { ambient 0 } }

camera { location <0, 3.9, -14> right 4/3*x look_at <0.2, 2.6, 0> angle 37.5 }
light_source { <-9, 10, -8> rgb <1.0, 0.93, 0.82>*1.15 area_light <2, 0, -2>, sqrt(8)*y, 6, 6 circular orient }
light_source { <9, 6, -10> rgb <0.6, 0.72, 0.9>*0.25 shadowless }
plane { -z, -4.5 pigment { rgb <0.50, 0.55, 0.50> } finish { diffuse 0.75 } }
plane { y, 0 pigment { rgb <0.30, 0.17, 0.09> } finish { diffuse 0.7 specular 0.2 roughness 0.03 reflection { 0.02, 0.2 } } }
#declare Glaze = finish { diffuse 0.78 specular 0.7 roughness 0.006 reflection { 0.02, 0.35 fresnel on } }
#declare White = rgb <0.88, 0.88, 0.84>; #declare Cobalt = rgb <0.03, 0.08, 0.36>;
// The vase: bands of cobalt, and in the widest of them diagonals that cross, by a function of angle and height.
#declare Net = function(x, y, z) { abs(sin(6*atan2(z, x) + 5*y))*abs(sin(6*atan2(z, x) - 5*y)) }
#declare Crossed = pigment { function { Net(x, y, z) } color_map { [0.10 Cobalt] [0.14 White] } scale 1/4 }
lathe {
  bezier_spline 16,
  <0.00, 0.00>, <0.30, 0.00>, <0.55, 0.00>, <0.62, 0.05>, <0.62, 0.05>, <0.72, 0.60>, <1.50, 1.00>, <1.45, 2.05>,
  <1.45, 2.05>, <1.40, 2.90>, <0.42, 2.80>, <0.40, 3.50>, <0.40, 3.50>, <0.38, 3.75>, <0.50, 3.90>, <0.66, 3.95>
  pigment {
    gradient y scale 4 pigment_map {
      [0.05 Cobalt] [0.05 White] [0.22 White] [0.22 Cobalt] [0.24 Cobalt] [0.24 Crossed] [0.66 Crossed]
      [0.66 Cobalt] [0.68 Cobalt] [0.68 White] [0.95 White] [0.95 Cobalt]
    }
  }
  finish { Glaze } interior { ior 1.5 } translate -1.1*x
}
// Twigs, and a blossom of five balls here and there.
#declare Dice = seed(11);
#macro Twig(Lean, Tall)
  #local Root = <-1.1, 3.6, 0>;
  sphere_sweep { b_spline 6, Root - 1.6*y, 0.07, Root - 0.4*y, 0.07, Root + Lean*0.3 + 0.4*y, 0.06,
    Root + Lean*0.35 + Tall*0.6*y, 0.05, Root + Lean + Tall*y, 0.03, Root + Lean*1.3 + (Tall + 0.4)*y, 0.02 pigment { rgb <0.16, 0.08, 0.05> } }
  #for (I, 0.25, 1, 0.15)
    union {
      #for (A, 0, 288, 72) sphere { 0, 1 scale <0.07, 0.03, 0.12> translate 0.13*z rotate A*y } #end
      sphere { 0, 0.05 pigment { rgb <0.75, 0.45, 0.10> } }
      pigment { rgb <0.90, 0.62, 0.62> } finish { diffuse 0.85 } rotate <-70 + 60*rand(Dice), 60*(rand(Dice) - 0.5), 0>
      translate Root + Lean*(0.3 + 0.7*I*I) + Tall*(0.4 + 0.6*I)*y + 0.1*<rand(Dice) - 0.5, 0, -0.7>
    }
  #end
#end
Twig(<2.1, 0, -0.4>, 1.2) Twig(<-1.2, 0, 0.2>, 1.5) Twig(<0.6, 0, 0.5>, 2.0)
// The bottle.
sor {
  8, <0.0, -0.2>, <0.62, 0>, <0.72, 0.5>, <0.66, 1.3>, <0.26, 1.95>, <0.19, 2.5>, <0.27, 2.75>, <0.3, 3.0>
  pigment { rgb <0.04, 0.22, 0.18> } finish { Glaze } interior { ior 1.5 } translate <1.35, 0, 0.9>
}
// The dish, an outline of eight waves, and what lies on it.
#macro Wavy(R) #for (I, -1, 17) , <cos(I*pi/8), sin(I*pi/8)>*R*(1 + 0.09*cos(I*pi)) #end #end
difference {
  prism { cubic_spline 0, 0.22, 19 Wavy(1.15) }
  prism { cubic_spline 0.1, 0.3, 19 Wavy(1.05) pigment { Cobalt } }
  pigment { White } finish { Glaze } interior { ior 1.5 } translate <2.35, 0, -1.9>
}
#for (I, 0, 6)
  sphere { <0.34*(I > 0)*2*cos(I*pi/3), 0.42, 0.34*(I > 0)*2*sin(I*pi/3)> + <2.35, 0, -1.9>, 0.32
    pigment { rgb <0.62, 0.05, 0.03> } finish { Glaze } interior { ior 1.5 } }
#end
