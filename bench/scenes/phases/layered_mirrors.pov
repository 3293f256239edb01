// Balls and slabs of layered stone between two mirrors.
// bench: +W480 +H360 -A
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <1.2, 2.2, -6> look_at <0, 0.9, 0> angle 48 }
light_source { <-2.5, 5, -4> rgb 0.9 }
light_source { <2.8, 3, -5> rgb 0.4 }
#declare Stone =
  texture {
    pigment {
      granite turbulence 0.3
      color_map { [0 rgb <0.25, 0.2, 0.2>] [0.45 rgb <0.6, 0.52, 0.48>] [0.75 rgb <0.78, 0.7, 0.62>] [1 rgb 0.95] }
      scale 0.9
    }
    finish { diffuse 0.7 specular 0.3 reflection 0.08 }
  }
  texture {
    pigment {
      marble turbulence 0.8
      color_map { [0 rgbt <0.1, 0.15, 0.2, 0.2>] [0.12 rgbt <0.5, 0.5, 0.5, 0.9>] [1 rgbt 1] }
      scale 0.6 rotate 35*z
    }
    finish { diffuse 0.6 }
  }
  texture {
    pigment { agate color_map { [0 rgbt <0.9, 0.85, 0.7, 0.4>] [0.3 rgbt 1] [1 rgbt 1] } scale 0.4 }
    finish { diffuse 0.6 phong 0.4 }
  }
plane { y, 0 texture { Stone scale 1.5 } }
plane { x, -3 pigment { rgb 0.1 } finish { diffuse 0.1 reflection 0.85 } }
plane { -x, -3 pigment { rgb 0.1 } finish { diffuse 0.1 reflection 0.85 } }
plane { -z, -3.5 texture { Stone } }
#for (I, 0, 2)
  sphere { <1.7*I - 1.7, 0.7, 0.6*mod(I, 2)>, 0.7 texture { Stone rotate 70*I*y } }
  box { <1.7*I - 2.2, 0, -1.6>, <1.7*I - 1.4, 0.35, -1.1> texture { Stone rotate 50*I } }
#end
