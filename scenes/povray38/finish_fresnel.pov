#version 3.8;
// Fresnel's law in the whole finish: lacquered balls, matte where they are seen head-on and bright at their rims; normals that turn away from
// the eye; a leaf that is lit from behind.
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -5> look_at <0, -0.1, 0> angle 55 }
light_source { <-4, 6, -5> 0.9 }
light_source { <6, 2, -2> rgb <0.25, 0.2, 0.15> }
plane { y, -1 pigment { checker rgb 0.25 rgb 0.75 } }
#macro Ball(X, C, Share)
  sphere {
    <X, -0.2, 0>, 0.8
    pigment { rgb C }
    finish { fresnel Share diffuse albedo 0.9 specular albedo 1 roughness 0.01 emission 0.05 reflection { 0 Share } }
    interior { ior 1.5 }
#end
Ball(-1.7, <0.8, 0.2, 0.15>, 1) }
Ball(0, <0.2, 0.6, 0.3>, 0.5) normal { gradient y 1.5 sine_wave scale 0.25 } }
Ball(1.7, <0.2, 0.3, 0.8>, 0) }
disc {
  <0.9, 0.9, 1>, <-0.3, -0.5, -1>, 0.7
  pigment { rgb <0.7, 0.8, 0.2> }
  finish { fresnel 0.6 diffuse 0.3, 0.9 phong 0.5 }
  interior { ior 1.3 }
}
