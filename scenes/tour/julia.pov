// A julia set of quaternions in iridescent metal, on cushions that are superellipsoids.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 irid_wavelength rgb <0.70, 0.52, 0.38> }
#default { finish { ambient 0 } }

camera { location <0, 3.6, -9> right 4/3*x look_at <0, 1.62, 0> angle 33 }
light_source { <-7, 10, -7> rgb <1.0, 0.92, 0.84>*1.1 area_light <3, 0, -3>, sqrt(18)*y, 5, 5 adaptive 1 circular orient }
light_source { <9, 5, -3> rgb <0.40, 0.55, 0.95>*0.55 }
light_source { <2, 9, 8> rgb <1.0, 0.7, 0.5>*0.6 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.03, 0.02, 0.04>] [0.4 rgb <0.16, 0.12, 0.20>] [0.62 rgb <0.9, 0.85, 0.8>] [1 rgb <0.3, 0.35, 0.5>] } } }
plane { y, 0 pigment { rgb <0.10, 0.06, 0.08> } finish { diffuse 0.8 specular 0.15 roughness 0.04 reflection { 0.02, 0.3 } } }

julia_fractal {
  <0.18, 0.1, -0.55, 0.55>
  quaternion sqr max_iteration 7 precision 80
  slice <0, 0, 0, 1>, 0
  pigment { rgb <0.72, 0.60, 0.46> }
  finish {
    diffuse 0.50 specular 0.8 roughness 0.02 metallic
    reflection { 0.22 metallic }
    irid { 0.55 thickness 0.42 turbulence 0.35 }
  }
  rotate <-14, 52, 0> scale 1.0 translate <0.05, 2.22, 0>
}
#macro Cushion(E, N, Wide, High, C)
  superellipsoid {
    <E, N> rotate 90*x scale <Wide, High, Wide>
    pigment { rgb C } finish { diffuse 0.8 specular 0.25 roughness 0.06 }
    normal { quilted 0.25 control0 0.6 control1 0.9 scale 0.36 }
  }
#end
object { Cushion(0.5, 0.75, 1.65, 0.36, <0.42, 0.03, 0.09>) rotate 28*y translate 0.36*y }
object { Cushion(0.8, 0.9, 1.15, 0.32, <0.05, 0.12, 0.30>) rotate -20*y translate 0.98*y }
