// The shadow of a tinted glass solid with ior: dark where POV-Ray bends no light, coloured through and through.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -5> look_at <0, 0.3, 0> angle 46 }
light_source { <4, 6, -3> rgb 1 }

difference {
  sphere { <-0.9, 0.8, 0>, 0.8 }
  cylinder { <-0.9, -1, 0>, <-0.9, 3, 0>, 0.3 }
  pigment { rgbf <0.4, 0.9, 0.5, 0.85> }
  finish { diffuse 0.2 specular 0.6 }
  interior { ior 1.3 }
}
box { <0.6, 0.05, -0.5>, <1.5, 1.1, 0.3> pigment { rgbf <0.9, 0.5, 0.9, 0.7> } interior { ior 1.5 caustics 0.8 } rotate -20*y }
plane { y, 0 pigment { rgb 0.85 } }
