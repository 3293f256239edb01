// Eggs (ovus), lemons (lemon) and a bowl: shapes of 3.8, speckles and peel by its functions as colours (user_defined).
#version 3.8;
global_settings { assumed_gamma 1 max_trace_level 4 }
#include "functions.inc"
#default { finish { ambient 0 fresnel on } }

camera { location <0, 3.5, -9.4> right 4/3*x look_at <0.1, 0.98, 0> angle 34 }
light_source { <-9, 7, -3.5>, rgb <1.0, 0.88, 0.70>*1.55 area_light <1.5, 0, -1.5>, sqrt(4.5)*y, 6, 6 adaptive 1 circular orient }
light_source { <7, 5, -9>, rgb <0.45, 0.55, 0.75>*0.30 shadowless }
plane { -z, -3.6 pigment { bozo scale 1.6 turbulence 0.5 color_map { [0 rgb <0.070, 0.060, 0.050>] [1 rgb <0.14, 0.115, 0.085>] } } finish { diffuse 0.8 } }
plane { y, 0 pigment { wood turbulence 0.07 scale <0.35, 0.35, 3> rotate <3, 88, 0> translate <0, 0.4, 1>
    color_map { [0 rgb <0.23, 0.12, 0.055>] [1 rgb <0.12, 0.055, 0.025>] } } finish { diffuse 0.75 specular 0.2 roughness 0.04 } }

// Speckles: dark where fine noise is high, more of them towards the blunt end, from a warm shell.
#declare Spots = function(x, y, z) { select(f_noise3d(x*9, y*9, z*9) + 0.35*f_noise3d(x*31, y*31, z*31) - 0.86 - 0.06*y, 1, 0.35) }
#macro Egg(Warm)
  ovus {
    0.46, 0.28
    pigment { user_defined {
      function { Spots(x, y, z)*(0.62 + 0.22*Warm) }, function { Spots(x, y, z)*(0.62 - 0.10*Warm) }, function { Spots(x, y, z)*(0.56 - 0.22*Warm) } } }
    finish { diffuse 0.8 specular 0.12 roughness 0.08 }
    translate -0.46*y
  }
#end
object { Egg(0.9) rotate <78, 0, 0> rotate 60*y translate <1.55, 0.46, -1.3> }
object { Egg(0.2) rotate <84, 0, 0> rotate -35*y translate <2.25, 0.46, -0.2> }
object { Egg(0.5) rotate <70, 0, 0> rotate 200*y translate <-2.05, 0.46, -0.75> }

// A lemon: the arc is the fruit, a short second one its nose; pits of the peel are a normal.
#macro Lemon(Ripe)
  union {
    lemon { -0.80*y, 0.06, 0.80*y, 0.06, 0.90 }
    lemon { -1.02*y, 0.04, -0.45*y, 0.16, 1.2 }
    lemon { 0.65*y, 0.16, 0.92*y, 0.06, 0.7 }
    pigment { user_defined { function { 0.80 + 0.05*y*y }, function { 0.52 + Ripe*(0.08*y*y - 0.1) }, function { 0.03 + 0.03*sin(3*x) } } }
    normal { crackle 0.35 scale 0.07 }
    finish { diffuse 0.8 specular 0.45 roughness 0.025 }
    scale 0.78
  }
#end
object { Lemon(0.3) rotate <90, 0, 0> rotate 62*y translate <-1.0, 0.53, -2.1> }
// Half a lemon shows what is within: ten parts, by angle.
difference {
  object { Lemon(0) }
  plane { -y, 0 pigment { user_defined {
    function { 0.88 }, function { select(sqrt(x*x + z*z) - 0.34, 0.50 + 0.26*pow(abs(cos(4.5*atan2(z, x))), 0.4), 0.84) }, function { select(sqrt(x*x + z*z) - 0.34, 0.08, 0.62) } } }
    finish { diffuse 0.8 specular 0.6 roughness 0.01 } }
  rotate <-72, 24, 0> translate <0.55, 0.50, -2.2>
}
// The bowl, and three more in it.
lathe {
  bezier_spline 12,
  <0.00, 0.10>, <0.30, 0.10>, <0.60, 0.10>, <0.70, 0.00>, <0.70, 0.00>, <0.90, 0.25>, <1.55, 0.50>, <1.72, 1.20>,
  <1.72, 1.20>, <1.66, 1.22>, <1.40, 0.40>, <0.00, 0.30>
  pigment { rgb <0.10, 0.20, 0.26> } finish { diffuse 0.7 specular 0.5 roughness 0.01 reflection { 0.02, 0.3 } }
}
object { Lemon(0.6) rotate <80, 30, 0> translate <-0.62, 1.05, -0.15> }
object { Lemon(0.1) rotate <75, -50, 0> translate <0.65, 1.05, 0.15> }
object { Lemon(1.0) rotate <88, 85, 8> translate <0, 1.62, 0.30> }
