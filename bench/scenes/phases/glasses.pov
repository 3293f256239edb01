// Twenty glasses: differences of solids of revolution under deep refraction.
// bench: +W320 +H240 -A
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 20 }
camera { location <0, 4, -9> look_at <0, 0.8, 0.5> angle 36 }
light_source { <-6, 10, -5> rgb 1 }
light_source { <7, 7, -6> rgb 0.4 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.85, 0.8>] [1 rgb <0.4, 0.55, 0.8>] } } }
plane { y, 0 pigment { checker rgb <0.8, 0.8, 0.78>, rgb <0.45, 0.28, 0.2> scale 0.8 } }
#declare Glass = merge {
  difference {
    sphere { 0, 1 scale <0.48, 0.8, 0.48> translate 1.4*y }
    sphere { 0, 0.95 scale <0.48, 0.8, 0.48> translate 1.42*y }
    plane { -y, -1.85 }
  }
  cylinder { 0.06*y, 0.67*y, 0.07 }
  cone { 0.02*y, 0.4, 0.2*y, 0.07 }
  cylinder { 0.002*y, 0.03*y, 0.41 }
  pigment { rgbf <0.97, 0.99, 0.98, 0.96> }
  finish { diffuse 0.05 specular 0.8 roughness 0.003 reflection { 0.03, 0.6 fresnel } conserve_energy }
  interior { ior 1.5 }
}
#for (I, 0, 19)
  object { Glass translate <1.25*(mod(I, 5) - 2) + 0.3*mod(int(I/5), 2), 0, 1.3*int(I/5) - 1> }
#end
